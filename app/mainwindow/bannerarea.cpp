// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bannerarea.h"

#include "widgets/forms/clickshield.h"
#include "widgets/theme/theme.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/motordiagram.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QLabel>
#include <QShortcut>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

// What it weighs that something is hidden.
constexpr int kArmed = 10000;
constexpr int kUsed = 1000;
constexpr int kMotors = 100;
constexpr int kHeading = 3;
constexpr int kActing = 1;
constexpr auto kDragged = std::chrono::milliseconds(200);

int weightOf(const QWidget &widget)
{
    if (qobject_cast<const ArmedState *>(&widget))
        return kArmed;
    if (qobject_cast<const MotorDiagram *>(&widget))
        return kMotors;
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return label->font().weight() >= QFont::DemiBold && !label->text().isEmpty() ? kHeading : 0;
    const bool acts = qobject_cast<const QAbstractButton *>(&widget)
        || qobject_cast<const QAbstractSlider *>(&widget) || qobject_cast<const ControlPad *>(&widget);
    return acts && widget.isEnabled() ? kActing : 0;
}

}  // namespace

BannerArea::BannerArea(QStackedWidget &pages, QWidget *parent)
    : QWidget(parent)
    , m_pages(pages)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&pages);
    connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_F6), this), &QShortcut::activated, this,
            &BannerArea::jump);
    // Once the page that comes has its size.
    connect(&pages, &QStackedWidget::currentChanged, this,
            [this] { QTimer::singleShot(0, this, &BannerArea::lookAgain); });
    connect(qApp, &QApplication::focusChanged, this, &BannerArea::followFocus);
}

// The keyboard wanders while its children are destroyed.
BannerArea::~BannerArea()
{
    qApp->disconnect(this);
}

void BannerArea::add(QWidget &banner, std::function<void()> close)
{
    banner.setParent(this);
    banner.hide();
    banner.installEventFilter(this);
    m_banners.push_back({&banner, std::move(close)});
}

void BannerArea::giveWayTo(QWidget &cover)
{
    m_cover = &cover;
    cover.installEventFilter(this);
}

// How far from that edge this area is covered.
int BannerArea::covered(bool lower) const
{
    if (!m_cover || m_cover->isHidden())
        return 0;
    const int begin = mapFromGlobal(m_cover->mapToGlobal(QPoint())).y();
    if (lower != (begin > height() / 2))
        return 0;
    return std::max(0, lower ? height() - begin : begin + m_cover->height());
}

// Where the row ends that holds the title of the page.
int BannerArea::headEnd() const
{
    const QWidget *page = m_pages.currentWidget();
    const auto *title = page ? page->findChild<QLabel *>(u"title"_s, Qt::FindDirectChildrenOnly) : nullptr;
    return title ? title->mapTo(this, QPoint(0, title->height())).y() : 0;
}

QPoint BannerArea::freePlace(const QWidget &ancestor, const std::function<int(int width)> &heightFor) const
{
    const QRect upper(0, headEnd() + Metric::kGap, width(), heightFor(width()));
    const QRect lower(0, height() - upper.height(), upper.width(), upper.height());
    return mapTo(&ancestor, (hidden(lower) < hidden(upper) ? lower : upper).topLeft());
}

bool BannerArea::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_cover) {
        const auto type = event->type();
        if (type == QEvent::Show || type == QEvent::Hide || type == QEvent::Resize || type == QEvent::Move)
            place();
        return QWidget::eventFilter(watched, event);
    }
    auto *widget = qobject_cast<QWidget *>(watched);
    switch (event->type()) {
    case QEvent::ShowToParent: appear(widget); break;
    case QEvent::HideToParent:
        shield(widget->geometry());
        std::erase_if(m_shown, [widget](const Banner &banner) { return banner.widget == widget; });
        makeRoom();
        break;
    case QEvent::LayoutRequest:
        place();
        uncoverState();
        break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

void BannerArea::appear(QWidget *widget)
{
    const auto known = std::find_if(m_banners.begin(), m_banners.end(),
                                    [widget](const Banner &banner) { return banner.widget == widget; });
    std::erase_if(m_shown, [widget](const Banner &banner) { return banner.widget == widget; });
    const bool isFirst = m_shown.empty();
    widget->setGeometry({});  // it was nowhere: nothing there is shielded
    m_shown.push_back(*known);
    place();
    if (isFirst)
        findPlace();
}

// Where least is hidden that has to be used or seen. Where that would be motors at either edge, or whether
// they may turn, the page makes room at its lower one: all other pages stay as they are.
void BannerArea::findPlace()
{
    const auto putAt = [this](bool lower) {
        m_lower = lower;
        for (Banner &banner : m_shown) {
            banner.offset = 0;
            banner.widget->setGeometry({});  // nothing is shielded where it was
        }
        place();
        return hidden(room(lower));
    };
    m_makesRoom = false;
    makeRoom();
    const int lower = putAt(true);
    const QRect below = room(true);
    const int upper = putAt(false);
    if (std::min(upper, lower) >= kMotors && !isPointerIn(below)) {
        m_makesRoom = true;
        putAt(true);
        if (m_makesRoom)
            return;
    }
    const auto used = [this](const QRect &room) { return isInUse(room) ? kUsed : 0; };
    if (lower + used(below) < upper + used(room(false)))
        putAt(true);
}

// The page gets lower by what the banners take of it, if it can; not while something in it is dragged.
void BannerArea::makeRoom()
{
    const bool isWanted = m_makesRoom && m_lower && !m_shown.empty();
    const int wanted = isWanted ? height() - room(true).top() : 0;
    const int fits = height() - m_pages.minimumSizeHint().height();
    if (wanted > fits)
        m_makesRoom = false;
    const int given = m_makesRoom ? wanted : 0;
    if (layout()->contentsMargins().bottom() == given)
        return;
    if (QApplication::mouseButtons() != Qt::NoButton) {
        QTimer::singleShot(kDragged, this, &BannerArea::makeRoom);
        return;
    }
    layout()->setContentsMargins(0, 0, 0, given);
    layout()->activate();
}

int BannerArea::heightOf(const QWidget &widget) const
{
    const int width = std::min(this->width() - 2 * Metric::kMargin, widget.maximumWidth());
    return widget.hasHeightForWidth() ? widget.heightForWidth(width) : widget.sizeHint().height();
}

// Each behind the one before it, and never nearer to the edge than it was.
void BannerArea::place()
{
    int next = Metric::kGap + std::max(covered(m_lower), m_lower ? 0 : headEnd());
    for (Banner &banner : m_shown) {
        banner.offset = std::max(banner.offset, next);
        const int height = heightOf(*banner.widget);
        const int y = m_lower ? this->height() - banner.offset - height : banner.offset;
        const int wide = std::min(width() - 2 * Metric::kMargin, banner.widget->maximumWidth());
        const QRect before = banner.widget->geometry();
        banner.widget->setGeometry(width() - Metric::kMargin - wide, y, wide, height);
        const QRect now = banner.widget->geometry();
        if (banner.widget->isVisible() && !before.isEmpty()
            && (height < before.height() || now.topLeft() != before.topLeft()))
            shield(before.united(now));
        banner.widget->raise();
        next = banner.offset + height + Metric::kGap;
    }
    makeRoom();
    ClickShield::raiseAll(*this);
}

void BannerArea::shield(const QRect &place)
{
    if (isVisible())
        new ClickShield(*this, place);
}

QRect BannerArea::room(bool lower) const
{
    int deep = 0;
    int near = height();
    for (const Banner &banner : m_shown) {
        deep = std::max(deep, banner.offset + heightOf(*banner.widget));
        near = std::min(near, banner.offset);
    }
    return {0, lower ? height() - deep : near, width(), deep - near};
}

bool BannerArea::isPointerIn(const QRect &room) const
{
    return room.contains(mapFromGlobal(QCursor::pos()));
}

bool BannerArea::isInUse(const QRect &room) const
{
    const QWidget *focus = QApplication::focusWidget();
    const bool isHere = focus && focus->isVisible() && isAncestorOf(focus) && !holds(focus);
    return isPointerIn(room)
        || (isHere && room.intersects(QRect(focus->mapTo(this, QPoint()), focus->size())));
}

// The part of a page's widget that is not scrolled away.
QRect BannerArea::shownPart(const QWidget &widget) const
{
    QRect part(widget.mapTo(this, QPoint()), widget.size());
    for (const QWidget *each = widget.parentWidget(); each && each != this; each = each->parentWidget())
        part &= QRect(each->mapTo(this, QPoint()), each->size());
    return part;
}

int BannerArea::hidden(const QRect &room) const
{
    int sum = 0;
    for (const QWidget *each : m_pages.currentWidget()->findChildren<QWidget *>()) {
        if (const int weight = each->isVisible() ? weightOf(*each) : 0; weight > 0)
            sum += room.intersects(shownPart(*each)) ? weight : 0;
    }
    return sum;
}

// Whether motors may turn must be seen at any moment.
bool BannerArea::hidesState(const QRect &room) const
{
    return hidden(room) >= kArmed;
}

// For another page.
void BannerArea::lookAgain()
{
    if (!m_shown.empty() && !isPointerIn(room(m_lower)) && !holds(QApplication::focusWidget()))
        findPlace();
}

void BannerArea::uncoverState()
{
    if (m_shown.empty() || m_makesRoom || isPointerIn(room(m_lower)) || holds(QApplication::focusWidget())
        || !hidesState(room(m_lower)) || hidesState(room(!m_lower)))
        return;
    m_lower = !m_lower;
    place();
}

bool BannerArea::holds(const QWidget *widget) const
{
    return std::any_of(m_banners.begin(), m_banners.end(), [widget](const Banner &banner) {
        return widget && (banner.widget == widget || banner.widget->isAncestorOf(widget));
    });
}

// Out of the way of the keyboard, but never from under the pointer; and back to the page from a banner that
// has gone.
void BannerArea::followFocus(QWidget *before, QWidget *now)
{
    if (holds(now) && !holds(before))
        m_before = before;
    if (holds(before) && !before->isVisible() && m_before && m_before->isVisible() && now != m_before) {
        m_before->setFocus(Qt::OtherFocusReason);
        return;
    }
    if (m_shown.empty() || m_makesRoom || holds(now) || isPointerIn(room(m_lower)))
        return;
    const QRect other = room(!m_lower);
    if (isInUse(room(m_lower)) && !isInUse(other) && !hidesState(other)) {
        m_lower = !m_lower;
        place();
    }
}

void BannerArea::jump()
{
    if (holds(QApplication::focusWidget())) {
        if (m_before)
            m_before->setFocus(Qt::ShortcutFocusReason);
        return;
    }
    if (m_shown.empty())
        return;
    const QWidget *newest = m_shown.back().widget;
    for (QWidget *child : newest->findChildren<QWidget *>()) {
        if (child->isVisible() && child->isEnabled() && (child->focusPolicy() & Qt::TabFocus)) {
            child->setFocus(Qt::ShortcutFocusReason);
            return;
        }
    }
}

void BannerArea::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    place();
}

void BannerArea::keyPressEvent(QKeyEvent *event)
{
    const auto newest = std::find_if(m_shown.rbegin(), m_shown.rend(),
                                     [](const Banner &banner) { return bool(banner.close); });
    if (event->key() == Qt::Key_Escape && newest != m_shown.rend())
        std::function(newest->close)();  // it may go with its banner
    else
        QWidget::keyPressEvent(event);
}
