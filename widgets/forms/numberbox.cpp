// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/numberbox.h"

#include "widgets/models/numbertext.h"
#include "widgets/theme/theme.h"

#include <QAbstractScrollArea>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>

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
    // Typed on, emptied, or replaced by a value from elsewhere, which the line keeps to itself.
    const auto lookAgain = [this] {
        if (m_refused)
            setRefused(!isTaken(typed()));
    };
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
    return !std::isnan(number) && isSame(number, nearestTo(number));
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
    if (!keepsText())
        interpretText();
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
    if (enter && !isTaken(typed())) {
        setRefused(true);
        event->accept();  // no default button takes it for a yes
        return;
    }
    if (event->key() == Qt::Key_Escape && m_refused) {
        lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
        setRefused(false);
        selectAll();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
}

// A click selects the whole number, as Tab does, and so does focus set by the program: what is typed next
// replaces it.
void NumberBox::focusInEvent(QFocusEvent *event)
{
    QDoubleSpinBox::focusInEvent(event);
    if (event->reason() == Qt::MouseFocusReason || event->reason() == Qt::OtherFocusReason)
        QTimer::singleShot(0, this, &QAbstractSpinBox::selectAll);  // after the press has set the cursor
    if (m_refused)
        showHint();
}

// The base class would put the old value in the place of what was typed, here and where it is hidden and
// shown. NOLINTBEGIN(bugprone-parent-virtual-call)
void NumberBox::focusOutEvent(QFocusEvent *event)
{
    setRefused(!isTaken(typed()));
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
    if (m_refused != refused) {
        m_refused = refused;
        setProperty("refused", refused);
        repolish(this);
    }
    if (refused)
        showHint();
    else
        delete m_hint;
}

void NumberBox::showHint()
{
    // One at a time: of several, they would cover each other. A red field shows its own when it gets the
    // focus.
    static QPointer<NumberBox> owner;
    if (owner && owner != this)
        delete owner->m_hint;
    owner = this;
    QWidget *canvas = canvasOf(this);
    if (!m_hint) {
        m_hint = new QToolButton(canvas);
        m_hint->setObjectName(u"hint"_s);
        m_hint->setFocusPolicy(Qt::NoFocus);  // the arrow keys in the field do the same
        connect(m_hint, &QToolButton::clicked, this, &NumberBox::takeNearest);
    }
    const double number = typedNumber(typed());
    const bool isInside = number >= minimum() && number <= maximum();
    const QString range = !isInside ? rangeText()
        : decimals() == 0           ? tr("Whole numbers, %1").arg(rangeText())
                                    : tr("At most %n decimal(s), %1", nullptr, decimals()).arg(rangeText());
    const QString text = std::isnan(number)
        ? tr("No number; %1. Back to %2").arg(range, textFromValue(value()))
        : tr("%1. Take %2").arg(range, textFromValue(nearestTo(number)));
    m_hint->setText(text);
    setAccessibleDescription(text);
    m_hint->adjustSize();
    m_hint->setGeometry(freePlace(m_hint, {mapTo(canvas, QPoint()), size()}, *canvas));
    m_hint->raise();
    m_hint->show();
}

void NumberBox::takeNearest()
{
    const double number = typedNumber(typed());
    const double wanted = std::isnan(number) ? value() : nearestTo(number);
    lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
    setRefused(false);
    setValue(wanted);
    selectAll();
}
