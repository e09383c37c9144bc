// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace palmer::ui {

/// A field of a form: label above, unit inside at the right, and where something required is missing a mark
/// and a bar. Empty means not stated. What is typed is read at once: what can be read is told by entered(),
/// what cannot stays in red with a short reason in the gap below, which moves nothing, and the value before
/// it is kept.
class Field : public QWidget {
    Q_OBJECT

public:
    enum class Kind { text, longText, number, choice };

    /// What a text typed says: as the field writes it, or why it is refused ("not a number").
    struct Reading {
        QString canonical;
        QString refusal;
    };
    using Reader = std::function<Reading(const QString &)>;

    static constexpr int headHeight = 20; ///< of the label and the gap below it, pixels

    explicit Field(Kind kind, QWidget *parent = nullptr);
    ~Field() override;
    Q_DISABLE_COPY_MOVE(Field)

    void setLabel(const QString &label);
    /// What is shown in the place of the label, which stays the name of the field: the head of a column.
    void setHeading(const QString &heading);
    /// Stands for %1 in the label.
    void setLabelArgument(const QString &argument);
    [[nodiscard]] QString labelArgument() const { return m_labelArgument; }
    void setUnit(const QString &unit);
    /// What an empty field shows in grey, if not that nothing is stated: what is taken in its place.
    void setPlaceholder(const QString &text);
    /// How texts are read; without one, every text is as it stands.
    void setReader(Reader reader);
    /// Characters a text may have; more are refused with a sentence. Without it what a test file holds of a
    /// text of its kind.
    void setMost(std::size_t characters) { m_most = characters; }
    /// The words of a choice; `none`: the first of them says that nothing is stated.
    void setChoices(const QStringList &words, bool none);

    /// Shows a value; `required`: it is missing and the report needs it. What is being typed and says the
    /// same stays as it is typed; what was refused stays until the value changes.
    void show(const QString &value, bool required);
    void showChoice(int index, bool required);
    void setRequired(bool required);
    /// Forgets what was typed and refused: another test, another document.
    void forget();
    /// Puts a text back that was refused; nothing where it can be read by now.
    void refuse(const QString &text);
    /// Reads a refused text again: what it depends on has changed.
    void reread();
    /// Without label and reason, for a place that has both: the label is still its accessible name.
    void setBare();
    /// Without label alone: the row above has it, of a table of fields.
    void hideLabel();

    /// The part that takes the focus.
    [[nodiscard]] QWidget *edit() const;
    /// What is in the field; empty for a choice that states nothing.
    [[nodiscard]] QString text() const;
    /// The text that is the value: what is in the field, or what was there before it was refused.
    [[nodiscard]] QString valueText() const { return isRefused() ? m_atFocus : text(); }
    [[nodiscard]] int choice() const;
    [[nodiscard]] bool isRequired() const { return m_required; }
    [[nodiscard]] bool isRefused() const { return !m_refusal.isEmpty(); }
    /// The sentence below a refused text.
    [[nodiscard]] QString refusal() const;
    /// Back to what was there before a text was typed that is refused; false: none is.
    bool undoRefused();

signals:
    /// A text was typed, which valueText() tells where it can be read; or a word was chosen.
    void entered();
    /// The focus came: what is typed from now on is a step of its own.
    void begun();

protected:
    void changeEvent(QEvent *event) override;
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
    void retranslate();
    [[nodiscard]] QString refusalText() const;
    [[nodiscard]] QString description() const;
    void placeParts();
    void placeReason();
    void makeReason();

    Kind m_kind;
    Reader m_reader;
    std::size_t m_most;
    std::optional<QString> m_ofNothing; ///< what an emptied field is taken for, until it is left
    bool m_bare = false;
    bool m_labelHidden = false;
    bool m_required = false;
    bool m_none = false;    ///< the first choice states nothing
    bool m_isTyped = false; ///< since the field was shown or left
    QString m_shown;        ///< the value as it was shown last
    QString m_atFocus;      ///< the value when the focus came
    QString m_refusal;      ///< why the text in the field is no value; empty: it is one
    QString m_labelSource;
    QString m_labelArgument;
    QString m_heading;
    QString m_placeholder;
    QLabel *m_label;
    QLabel *m_mark;
    QLineEdit *m_line = nullptr;
    QPlainTextEdit *m_lines = nullptr;
    QComboBox *m_choice = nullptr;
    QLabel *m_unit;
    QWidget *m_bar;
    QPointer<QWidget> m_reasonRow; ///< over what surrounds the field, as a child of it
    QLabel *m_reason = nullptr;
};

} // namespace palmer::ui
