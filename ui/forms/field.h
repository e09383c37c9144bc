// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

namespace palmer::ui {

/// A form field: label above, unit inside on the right, and a mark and a bar if it is required and empty.
/// Empty means not stated. Typing is read at once: valid text emits entered(); invalid text stays in red
/// with a short reason in the gap below, which moves nothing, and the former value is kept. Over 500 lines:
/// text, choice and each state (required, refused, restored) share one frame.
class Field : public Translated<QWidget, QEvent::FontChange, QEvent::PaletteChange> {
    Q_OBJECT

public:
    /// answer: yes, no or not stated, as a check box with its label beside it; unchecked is no.
    enum class Kind { text, longText, number, choice, answer };

    /// The value of a typed text in canonical form, or why it is refused ("not a number").
    struct Reading {
        QString canonical;
        QString refusal;
    };
    using Reader = std::function<Reading(const QString &)>;

    static constexpr int headHeight = 20; ///< height of the label and the gap below it, pixels

    explicit Field(Kind kind, QWidget *parent = nullptr);
    ~Field() override;
    Q_DISABLE_COPY_MOVE(Field)

    void setLabel(const QString &label);
    /// Displayed in place of the label, as a column heading; the label remains the field's name.
    void setHeading(const QString &heading);
    /// Replaces %1 in the label.
    void setLabelArgument(const QString &argument);
    [[nodiscard]] QString labelArgument() const { return m_labelArgument; }
    void setUnit(const QString &unit);
    /// Grey text of an empty field: the value used instead, by default that nothing is stated.
    void setPlaceholder(const QString &text);
    /// Callback that reads texts; without it every text is accepted as typed.
    void setReader(Reader reader);
    /// Maximum length of a text in characters; longer ones are refused with a message. By default the maximum
    /// of a test file for that kind of text.
    void setMost(std::size_t characters) { m_most = characters; }
    /// Texts of a choice; `none`: the first one means not stated.
    void setChoices(const QStringList &words, bool none);

    /// Shows a value; `required`: it is missing and needed for the report. Typed text with the same value
    /// stays as typed; a refused text stays until the value changes.
    void show(const QString &value, bool required);
    void showChoice(int index, bool required);
    void setRequired(bool required);
    /// Marks an empty field that only good practice asks for.
    void setUsual(bool usual);
    /// Discards typed and refused text, for another test or document.
    void forget();
    /// Restores a refused text; does nothing if it can be read now.
    void refuse(const QString &text);
    /// Reads a refused text again after something it depends on has changed.
    void reread();
    /// Hides label and reason, for use where both are shown elsewhere; the label remains the accessible name.
    void setBare();
    /// Places the label close to a lower field.
    void setDense();
    /// Hides only the label, as in a table of fields with a header row.
    void hideLabel();

    /// The widget that takes the focus.
    [[nodiscard]] QWidget *edit() const;
    /// Text in the field; empty for a choice that states nothing.
    [[nodiscard]] QString text() const;
    /// Text of the value: the text in the field, or the one before it was refused.
    [[nodiscard]] QString valueText() const { return isRefused() ? m_atFocus : text(); }
    [[nodiscard]] int choice() const;
    [[nodiscard]] bool isRequired() const { return m_required; }
    [[nodiscard]] bool isUsual() const { return m_usual; }
    [[nodiscard]] bool isRefused() const { return !m_refusal.isEmpty(); }
    /// The message below a refused text.
    [[nodiscard]] QString refusal() const;
    /// Restores the text from before a refused one was typed. False if none is refused.
    bool undoRefused();

signals:
    /// A text was typed (see valueText() if it is valid), or a choice was made.
    void entered();
    /// The field was focused: typing from now on is a new undo step.
    void begun();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void moveEvent(QMoveEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] Reading read(const QString &text) const;
    void setText(const QString &text);
    void typed();
    void finish();
    void restore();
    void retranslate() final;
    [[nodiscard]] bool isDense() const;
    [[nodiscard]] bool isRefusedInHead() const;
    [[nodiscard]] QString refusalText() const;
    [[nodiscard]] QString description() const;
    void placeParts();
    void placeReason();
    void makeReason();

    Kind m_kind;
    Reader m_reader;
    std::size_t m_most;
    int m_height;                       ///< of the line, pixels
    std::optional<QString> m_ofNothing; ///< the value of the emptied field, until it is left
    bool m_bare = false;
    bool m_labelHidden = false;
    bool m_required = false;
    bool m_usual = false;
    bool m_none = false;    ///< the first choice means not stated
    bool m_isTyped = false; ///< since the field was shown or left
    QString m_shown;        ///< the value last shown
    QString m_atFocus;      ///< the value when the field was focused
    QString m_refusal;      ///< why the text is invalid; empty if valid
    QString m_labelSource;
    QString m_labelArgument;
    QString m_heading;
    QString m_placeholder;
    QLabel *m_label;
    QLabel *m_mark;
    QLineEdit *m_line = nullptr;
    QPlainTextEdit *m_lines = nullptr;
    QComboBox *m_choice = nullptr;
    QCheckBox *m_answer = nullptr;
    QStringList m_words; ///< of an answer
    QLabel *m_unit;
    QWidget *m_bar;
    QWidget *m_refusedMark;        ///< in a dense field without a label
    QPointer<QWidget> m_reasonRow; ///< child of a surrounding widget, painted over it
    QLabel *m_reason = nullptr;
};

} // namespace palmer::ui
