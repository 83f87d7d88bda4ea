// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/numberbox.h"

#include "widgets/forms/latebutton.h"
#include "widgets/models/numbertext.h"
#include "widgets/theme/theme.h"

#include <QAbstractScrollArea>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

/// What a widget scrolls with, or its window: there a hint stays beside it.
QWidget *canvasOf(QWidget *widget)
{
    QWidget *canvas = widget;
    while (canvas->parentWidget() && !canvas->isWindow()) {
        const auto *area = qobject_cast<QAbstractScrollArea *>(canvas->parentWidget()->parentWidget());
        if (area && area->viewport() == canvas->parentWidget())
            break;
        canvas = canvas->parentWidget();
    }
    return canvas;
}

/// Below, above or beside a field, where it covers no other control if there is such a place.
QRect freePlace(const QWidget *hint, const QRect &field, const QWidget &canvas)
{
    const QSize size = hint->size();
    QRect place(QPoint(), size);
    QList<QRect> places;
    place.moveTopRight(field.bottomRight() + QPoint(0, 1));
    places.append(place);
    place.moveBottomRight(field.topRight() - QPoint(0, 1));
    places.append(place);
    for (const int x : {field.right() + 2, field.left() - 2 - size.width()}) {
        place.moveTopLeft({x, field.center().y() - size.height() / 2});
        places.append(place);
    }
    for (QRect &each : places)
        each.moveLeft(std::max(0, each.left()));
    const auto isFree = [&canvas, hint](const QRect &wanted) {
        if (!canvas.rect().contains(wanted))
            return false;
        for (const QWidget *widget : canvas.findChildren<QWidget *>()) {
            const bool isHint = widget != hint && widget->objectName() == hint->objectName();
            if ((isHint || widget->focusPolicy() != Qt::NoFocus) && widget->isVisible()
                && QRect(widget->mapTo(&canvas, QPoint()), widget->size()).intersects(wanted)
                && !qobject_cast<const QAbstractScrollArea *>(widget))
                return false;
        }
        return true;
    };
    const auto found = std::find_if(places.begin(), places.end(), isFree);
    return found == places.end() ? places.front() : *found;
}

}  // namespace

NumberBox::NumberBox(QWidget *parent)
    : QDoubleSpinBox(parent)
{
    setKeyboardTracking(false);  // 3 on the way to 300 is no value
    // Typed on, emptied, or replaced by a value from elsewhere, which the line keeps to itself.
    const auto lookAgain = [this] {
        if (!lineEdit()->isModified())
            m_settled = lineEdit()->text();
        if (m_refused)
            setRefused(!isTaken(typed()));
    };
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { m_selectsAll = false; });
    connect(lineEdit(), &QLineEdit::textChanged, this, lookAgain);
    connect(this, &QDoubleSpinBox::textChanged, this, lookAgain);
}

NumberBox::NumberBox(double low, double high, int decimals, const QString &suffix)
    : NumberBox(nullptr)
{
    setDecimals(decimals);
    setRange(low, high);
    setSuffix(suffix);
}

NumberBox::~NumberBox()
{
    delete m_hint;
}

void NumberBox::setEmptyAllowed(bool allowed, const QString &placeholder)
{
    m_emptyAllowed = allowed;
    lineEdit()->setPlaceholderText(placeholder);
}

QString NumberBox::textFromValue(double value) const
{
    return numberText(value, decimals());
}

QString NumberBox::typed() const
{
    return bare(lineEdit()->text());
}

/// Without what stands before and behind the number.
QString NumberBox::bare(QString text) const
{
    if (!prefix().isEmpty() && text.startsWith(prefix()))
        text.remove(0, prefix().size());
    // The unit may have been typed as well.
    text = text.trimmed();
    for (const QString unit = suffix().trimmed(); !unit.isEmpty() && text.endsWith(unit);)
        text = text.chopped(unit.size()).trimmed();
    return text;
}

bool NumberBox::isTaken(const QString &text) const
{
    if (m_emptyAllowed && text.isEmpty())
        return true;
    if (text == textFromValue(value()) || (!specialValueText().isEmpty() && text == specialValueText()))
        return true;  // what the board holds, in range or not
    const double number = typedNumber(text);
    return !std::isnan(number) && isCertain(text) && isSame(number, nearestTo(number));
}

/// There is but one way to read it: "1.000" may be one or a thousand.
bool NumberBox::isCertain(const QString &text) const
{
    static const QRegularExpression decimal(u"[.,]\\d"_s);
    return decimals() == 0 ? !text.contains(decimal) : decimals() > 2 || !groupedNumber(text);
}

QValidator::State NumberBox::validate(QString &text, int &) const
{
    return isTaken(bare(text)) ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString &shown) const
{
    const QString text = bare(shown);
    if (!specialValueText().isEmpty() && text == specialValueText())
        return minimum();
    const double number = text == textFromValue(value()) ? value() : typedNumber(text);
    return std::isnan(number) ? value() : number;
}

void NumberBox::fixup(QString &) const { }

bool NumberBox::settle()
{
    setRefused(!isTaken(typed()));
    // Not by interpretText(), which takes nothing that the program puts into a field that was cleared.
    if (!keepsText())
        setValue(valueFromText(lineEdit()->text()));
    if (!m_refused)
        m_settled = lineEdit()->text();
    return !m_refused;
}

NumberBox *NumberBox::refusedIn(QWidget &form)
{
    for (NumberBox *box : form.findChildren<NumberBox *>()) {
        if (box->isVisibleTo(&form) && !box->settle()) {
            box->setFocus(Qt::OtherFocusReason);
            return box;
        }
    }
    return nullptr;
}

void NumberBox::type(const QString &text)
{
    lineEdit()->setText(prefix() + text + suffix());
    setRefused(!isTaken(text));
}

void NumberBox::goOnTyping(const QString &text)
{
    const QString settled = m_settled;
    lineEdit()->setText(prefix() + text + suffix());
    m_settled = settled;
    lineEdit()->setCursorPosition(int(prefix().size() + text.size()));
    lineEdit()->setModified(true);
}

void NumberBox::goBack()
{
    const bool isSpecial = !specialValueText().isEmpty() && value() == minimum();
    lineEdit()->setText(isSpecial ? specialValueText() : prefix() + textFromValue(value()) + suffix());
    setRefused(false);
}

// False: nothing was typed.
bool NumberBox::takeBack()
{
    const bool isTyped = lineEdit()->isModified() && lineEdit()->text() != m_settled;
    if (!m_refused && !isTyped)
        return false;
    if (!m_refused)
        lineEdit()->setText(m_settled);
    if (m_refused || !isTaken(typed()))
        goBack();
    selectAll();
    return true;
}

double NumberBox::nearestTo(double value) const
{
    const double unit = std::pow(10.0, -decimals());
    return std::clamp(std::round(value / unit) * unit, minimum(), maximum());
}

bool NumberBox::isSame(double typed, double nearest) const
{
    return std::abs(typed - nearest) < 1e-3 * std::pow(10.0, -decimals());
}

QString NumberBox::rangeText() const
{
    return tr("%1 to %2").arg(textFromValue(minimum()), textFromValue(maximum()));
}

void NumberBox::stepBy(int steps)
{
    if (m_refused)
        takeNearest();
    else
        QDoubleSpinBox::stepBy(steps);
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && !settle()) {
        event->accept();  // no default button takes it for a yes
        return;
    }
    if (event->key() == Qt::Key_Escape && takeBack())
        return;
    QDoubleSpinBox::keyPressEvent(event);
}

// A click selects the whole number, as Tab does, and so does focus set by the program: what is typed next
// replaces it.
void NumberBox::focusInEvent(QFocusEvent *event)
{
    QDoubleSpinBox::focusInEvent(event);
    m_selectsAll = event->reason() == Qt::MouseFocusReason || event->reason() == Qt::OtherFocusReason;
    if (m_selectsAll)
        // After the press has set the cursor, but not over a key that came with it.
        QTimer::singleShot(0, this, [this, text = lineEdit()->text()] {
            if (std::exchange(m_selectsAll, false) && lineEdit()->text() == text)
                selectAll();
        });
    if (m_refused)
        showHint();
}

// The base class would put the old value in the place of what was typed, here and where its window is left,
// where the language changes, and where it is hidden and shown. NOLINTBEGIN(bugprone-parent-virtual-call)
void NumberBox::changeEvent(QEvent *event)
{
    const bool replaces = event->type() == QEvent::ActivationChange || event->type() == QEvent::LocaleChange;
    if (replaces && (keepsText() || !isTaken(typed())))
        QWidget::changeEvent(event);
    else
        QDoubleSpinBox::changeEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent *event)
{
    settle();
    if (!keepsText()) {
        QDoubleSpinBox::focusOutEvent(event);
        return;
    }
    lineEdit()->event(event);
    QWidget::focusOutEvent(event);
}

void NumberBox::hideEvent(QHideEvent *event)
{
    setRefused(!isTaken(typed()));
    if (m_hint)
        m_hint->hide();
    if (keepsText())
        QWidget::hideEvent(event);
    else
        QDoubleSpinBox::hideEvent(event);
}

void NumberBox::showEvent(QShowEvent *event)
{
    if (keepsText())
        QWidget::showEvent(event);
    else
        QDoubleSpinBox::showEvent(event);
    if (m_refused)
        showHint();
}

// NOLINTEND(bugprone-parent-virtual-call)

void NumberBox::moveEvent(QMoveEvent *event)
{
    QDoubleSpinBox::moveEvent(event);
    if (m_hint)
        showHint();
}

void NumberBox::setRefused(bool refused)
{
    const bool before = std::exchange(m_refused, refused);
    if (before != refused) {
        setProperty("refused", refused);
        repolish(this);
    }
    if (refused)
        showHint();
    else
        delete m_hint;
    if (before || refused)
        emit refusedChanged();
}

QString NumberBox::rangeSentence(const QString &text) const
{
    const double number = typedNumber(text);
    if (std::isnan(number))
        return rangeText();
    if (const auto grouped = groupedNumber(text); grouped && !isCertain(text))
        return tr("Can be read as %1 or as %2; %3")
            .arg(shortNumberText(number), shortNumberText(*grouped), rangeText());
    if (number < minimum() || number > maximum())
        return rangeText();
    return decimals() == 0 ? tr("Whole numbers, %1").arg(rangeText())
                           : tr("At most %n decimal(s), %1", nullptr, decimals()).arg(rangeText());
}

/// The value nearest to what was typed; of two ways to read it, to the one that can be meant.
double NumberBox::offered(const QString &text) const
{
    const double number = typedNumber(text);
    const auto grouped = isCertain(text) ? std::nullopt : groupedNumber(text);
    if (grouped && *grouped >= minimum() && *grouped <= maximum())
        return nearestTo(*grouped);
    return std::isnan(number) ? value() : nearestTo(number);
}

QString NumberBox::advice() const
{
    const QString range = rangeSentence(typed());
    const QString nearest = textFromValue(offered(typed()));
    return std::isnan(typedNumber(typed())) ? tr("No number; %1. Go back to %2").arg(range, nearest)
                                            : tr("%1. Take %2").arg(range, nearest);
}

void NumberBox::showHint()
{
    if (!isVisible() || window()->isHidden())  // or about to be
        return;
    // One at a time: of several, they would cover each other. A red field shows its own when it gets the
    // focus.
    static QPointer<NumberBox> owner;
    if (owner && owner != this)
        delete owner->m_hint;
    owner = this;
    QWidget *canvas = canvasOf(this);
    if (!m_hint) {
        m_hint = new LateButton(canvas);
        m_hint->setObjectName(u"hint"_s);
        m_hint->setFocusPolicy(Qt::NoFocus);  // the arrow keys in the field do the same
        connect(m_hint, &LateButton::clicked, this, &NumberBox::takeNearest);
    }
    const QString text = advice();
    m_hint->setText(text);
    setAccessibleDescription(text);
    m_hint->adjustSize();
    m_hint->setGeometry(freePlace(m_hint, {mapTo(canvas, QPoint()), size()}, *canvas));
    m_hint->raise();
    m_hint->show();
}

void NumberBox::takeNearest()
{
    const double wanted = offered(typed());
    goBack();
    setValue(wanted);
    selectAll();
}
