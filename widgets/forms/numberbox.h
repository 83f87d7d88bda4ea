// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QPointer>

#include <optional>

class QToolButton;

/// A field for a number. What is typed is neither dropped nor clipped: a text that is no value of this field
/// stays as it was typed, the field turns red, says what it takes and offers the nearest value; until then it
/// keeps the value that it had. Comma and point both part the decimals; digits are not grouped.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT
public:
    explicit NumberBox(QWidget *parent = nullptr);
    /// @param decimals 0 for whole numbers
    NumberBox(double low, double high, int decimals, const QString &suffix = {});
    ~NumberBox() override;

    /// An empty field is one without a value, and stays empty until there is one.
    void setEmptyAllowed(bool allowed) { m_emptyAllowed = allowed; }
    /// What stands in the field was typed and is no value of it.
    [[nodiscard]] bool isRefused() const { return m_refused; }
    /// Takes what stands in the field as if it had been left. False: it is refused.
    bool settle();
    /// The first field in a form whose text is refused, with the focus; null if all are settled. What the
    /// form would do with the value from before is not what the operator sees.
    static NumberBox *refusedIn(QWidget &form);

    QValidator::State validate(QString &text, int &position) const override;
    double valueFromText(const QString &text) const override;
    QString textFromValue(double value) const override;
    void fixup(QString &text) const override;
    /// From a refused text, the nearest value.
    void stepBy(int steps) override;

protected:
    /// The nearest value that the field takes.
    [[nodiscard]] virtual double nearestTo(double value) const;
    /// Whether that one may stand for what was typed, such as the nearest count of a register.
    [[nodiscard]] virtual bool isSame(double typed, double nearest) const;
    /// What the field takes: "0 to 255".
    [[nodiscard]] virtual QString rangeText() const;

    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void moveEvent(QMoveEvent *event) override;

private:
    [[nodiscard]] bool isTaken(const QString &text) const;
    [[nodiscard]] QString bare(QString text) const;
    [[nodiscard]] QString typed() const;
    [[nodiscard]] bool keepsText() const { return m_refused || (m_emptyAllowed && typed().isEmpty()); }
    void setRefused(bool refused);
    void showHint();
    void takeNearest();

    bool m_refused = false;
    bool m_emptyAllowed = false;
    QPointer<QToolButton> m_hint;
};
