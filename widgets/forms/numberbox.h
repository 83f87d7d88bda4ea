// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QPointer>

#include <optional>

class LateButton;

/// A field for a number. What is typed is neither dropped nor clipped: a text that is no value of this field
/// stays as it was typed, the field turns red, says what it takes and offers the nearest value; until then it
/// keeps the value that it had. Comma and point both part the decimals; digits are not grouped, and what
/// could be meant so is refused. A value counts once it is finished: with Enter, or when the field is left;
/// until then Esc takes back what was typed.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT
public:
    explicit NumberBox(QWidget *parent = nullptr);
    /// @param decimals 0 for whole numbers
    NumberBox(double low, double high, int decimals, const QString &suffix = {});
    ~NumberBox() override;

    /// An empty field is one without a value, and stays empty until there is one.
    /// @param placeholder what an empty field shows
    void setEmptyAllowed(bool allowed, const QString &placeholder = {});
    [[nodiscard]] bool isEmpty() const { return typed().isEmpty(); }
    /// What stands in the field was typed and is no value of it.
    [[nodiscard]] bool isRefused() const { return m_refused; }
    /// Takes what stands in the field as if it had been left. False: it is refused.
    bool settle();
    /// What stands in the field, without what is put before and behind it.
    [[nodiscard]] QString typed() const;
    /// What was typed into the field earlier stands there again.
    void type(const QString &text);
    /// The same for a text that is not finished yet: it counts when the field is left.
    void goOnTyping(const QString &text);
    /// The value takes the place of what was typed.
    void goBack();
    /// What the field takes, and what it offers in place of a refused text.
    [[nodiscard]] QString advice() const;
    /// What the field takes, in answer to a text that it refuses.
    [[nodiscard]] QString rangeSentence(const QString &text) const;
    /// The first field in a form whose text is refused, with the focus; null if all are settled. What the
    /// form would do with the value from before is not what the operator sees.
    static NumberBox *refusedIn(QWidget &form);

    QValidator::State validate(QString &text, int &position) const override;
    double valueFromText(const QString &text) const override;
    QString textFromValue(double value) const override;
    void fixup(QString &text) const override;
    /// From a refused text, the nearest value.
    void stepBy(int steps) override;

signals:
    /// A text was refused, is typed on, or is gone.
    void refusedChanged();

protected:
    /// The nearest value that the field takes.
    [[nodiscard]] virtual double nearestTo(double value) const;
    /// Whether that one may stand for what was typed, such as the nearest count of a register.
    [[nodiscard]] virtual bool isSame(double typed, double nearest) const;
    /// What the field takes: "0 to 255".
    [[nodiscard]] virtual QString rangeText() const;

    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void moveEvent(QMoveEvent *event) override;

private:
    [[nodiscard]] bool isTaken(const QString &text) const;
    [[nodiscard]] QString bare(QString text) const;
    [[nodiscard]] bool isCertain(const QString &text) const;
    [[nodiscard]] double offered(const QString &text) const;
    [[nodiscard]] bool keepsText() const { return m_refused || (m_emptyAllowed && typed().isEmpty()); }
    void setRefused(bool refused);
    bool takeBack();
    void showHint();
    void takeNearest();

    QString m_settled;  // the line as it was before it was typed into
    bool m_refused = false;
    bool m_emptyAllowed = false;
    bool m_selectsAll = false;  // as soon as the focus has settled
    QPointer<LateButton> m_hint;
};
