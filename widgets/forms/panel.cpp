// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/panel.h"

#include "widgets/forms/clickshield.h"
#include "widgets/forms/keyboard.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QFrame>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

/// A shade over the content, with a dialog in a frame in its middle.
class Panel final : public QWidget
{
public:
    Panel(QDialog &dialog, QWidget *parent)
        : QWidget(parent)
        , m_dialog(dialog)
        , m_frame(new QFrame(this))
        , m_title(new QLabel(dialog.windowTitle()))
        , m_before(QApplication::focusWidget())
        , m_first(dialog.focusWidget())
        , m_wanted(dialog.testAttribute(Qt::WA_Resized) ? dialog.size() : QSize(0, 0))
    {
        m_frame->setObjectName(u"panel"_s);
        m_frame->installEventFilter(this);
        m_title->setObjectName(u"title"_s);
        m_title->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, 0);
        auto *layout = new QVBoxLayout(m_frame);
        layout->setContentsMargins(1, 1, 1, 1);
        layout->setSpacing(0);
        layout->addWidget(m_title);
        dialog.setAttribute(Qt::WA_Moved);  // else it moves itself to the middle of its parent
        dialog.setParent(m_frame, Qt::Widget);
        layout->addWidget(&dialog, 1);
        if (dialog.layout())
            dialog.layout()->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin,
                                                Metric::kMargin);
        setAccessibleName(dialog.windowTitle());
    }

    [[nodiscard]] QDialog &dialog() const { return m_dialog; }

    void start()
    {
        show();
        m_dialog.show();
        fit();
        firstFocus()->setFocus(Qt::PopupFocusReason);
        shield();
    }

    /// A click or Return that comes now was meant for what was there before.
    void shield() { new ClickShield(*m_frame); }
    [[nodiscard]] QRect place() const { return m_frame->geometry(); }

    /// To what had it before the dialog; outside of this area to no button that acts, which may have got it
    /// only when what opened the dialog went.
    void giveFocusBack() const
    {
        if (m_before && m_before->isVisible() && m_before->isEnabled()
            && (parentWidget()->isAncestorOf(m_before) || mayTakeKeyboard(*m_before)))
            m_before->setFocus(Qt::PopupFocusReason);
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            fit();
        return QWidget::eventFilter(watched, event);
    }

protected:
    /// Tab stays in the dialog: what it would lead to is in reach of the mouse and of its own key, and acts.
    bool focusNextPrevChild(bool next) override
    {
        QWidget *now = QApplication::focusWidget();
        // A panel that goes lets the keyboard out.
        if (!now || !isVisible() || !m_frame->isAncestorOf(now))
            return QWidget::focusNextPrevChild(next);
        const auto after = [next](const QWidget *widget) {
            return next ? widget->nextInFocusChain() : widget->previousInFocusChain();
        };
        for (QWidget *widget = after(now); widget != now; widget = after(widget)) {
            if (m_frame->isAncestorOf(widget) && widget->isVisible() && widget->isEnabled()
                && (widget->focusPolicy() & Qt::TabFocus) && !widget->focusProxy()) {
                widget->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
                break;
            }
        }
        return true;
    }
    void resizeEvent(QResizeEvent *) override { fit(); }
    void paintEvent(QPaintEvent *) override { QPainter(this).fillRect(rect(), QColor(0, 0, 0, 110)); }

private:
    void fit()
    {
        constexpr int kAround = Metric::kGap;
        // A message box fixes its size by that of the screen, which cuts its buttons where that is small or
        // magnified; here the window gives the room.
        if (m_dialog.minimumSize() == m_dialog.maximumSize()) {
            m_dialog.setMinimumSize(0, 0);
            m_dialog.setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
        }
        const QRect room = rect().adjusted(kAround, kAround, -kAround, -kAround);
        const QSize wanted(m_wanted.width(), m_wanted.height() + m_title->sizeHint().height());
        const QSize size = m_frame->sizeHint().expandedTo(wanted).boundedTo(room.size());
        m_frame->setGeometry(QStyle::alignedRect(layoutDirection(), Qt::AlignCenter,
                                                 size.expandedTo(m_frame->minimumSizeHint()), room));
    }

    /// The widget that the dialog chose, its default button, or what Tab reaches first.
    [[nodiscard]] QWidget *firstFocus() const
    {
        if (m_first && m_first != &m_dialog)
            return m_first;
        const auto buttons = m_dialog.findChildren<QPushButton *>();
        const auto usual = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton *button) {
            return button->isDefault() && button->isEnabled();
        });
        if (usual != buttons.end())
            return *usual;
        for (QWidget *next = m_dialog.nextInFocusChain(); next != &m_dialog;
             next = next->nextInFocusChain()) {
            if (m_dialog.isAncestorOf(next) && next->isVisible() && next->isEnabled()
                && (next->focusPolicy() & Qt::TabFocus))
                return next;
        }
        return &m_dialog;
    }

    QDialog &m_dialog;
    QFrame *m_frame;
    QLabel *m_title;
    QPointer<QWidget> m_before;
    QPointer<QWidget> m_first;  // what the dialog chose; forgotten when it gets another parent
    QSize m_wanted;
};

PanelArea::PanelArea(QWidget *content, QWidget *parent)
    : QWidget(parent)
    , m_content(content)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(content);
}

PanelArea::~PanelArea()
{
    for (const Panel *panel : std::as_const(m_panels))
        panel->dialog().disconnect(this);
}

void PanelArea::open(QDialog &dialog)
{
    const bool wasOpen = isOpen();
    auto *panel = new Panel(dialog, this);
    panel->setGeometry(rect());
    m_panels.append(panel);
    update(wasOpen);
    panel->start();
    connect(&dialog, &QDialog::finished, this, [this, panel] {
        panel->dialog().disconnect(this);  // it may outlive this area's end
        close(panel);
    });
    connect(&dialog, &QObject::destroyed, this, [this, panel] { close(panel); });
}

void PanelArea::close(Panel *panel)
{
    if (!m_panels.removeOne(panel))
        return;
    panel->hide();
    panel->deleteLater();
    update(true);
    panel->giveFocusBack();
    if (isOpen())
        m_panels.last()->shield();
    else if (isVisible())
        new ClickShield(*this, panel->place());
}

void PanelArea::update(bool wasOpen)
{
    m_content->setEnabled(!isOpen());
    for (Panel *panel : std::as_const(m_panels))
        panel->setEnabled(panel == m_panels.last());
    if (wasOpen != isOpen())
        emit openChanged(isOpen());
}

void PanelArea::rejectAll()
{
    while (isOpen())
        m_panels.last()->dialog().reject();
}

QDialog *PanelArea::newest() const
{
    return isOpen() ? &m_panels.last()->dialog() : nullptr;
}

void PanelArea::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    for (Panel *panel : std::as_const(m_panels))
        panel->setGeometry(rect());
}

void openPanel(QDialog &dialog)
{
    QWidget *owner = dialog.parentWidget();
    if (auto *area = owner ? owner->window()->findChild<PanelArea *>() : nullptr)
        area->open(dialog);
    else
        dialog.open();
}
