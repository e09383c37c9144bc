#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/forms/field.h"
#include "ui/model/selection.h"

#include <QScrollArea>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace palmer::ui {

class Chip;

/// What a field may look at to say its value.
struct FormSource {
    const Document &document;
    const Test *test; ///< null outside of tests
    const Language &language;
};

// What is stated, as fields show it; empty for what is not.
[[nodiscard]] QString stated(const std::string &text);
[[nodiscard]] QString stated(const std::optional<double> &value, Quantity quantity, const Language &language);
[[nodiscard]] QString statedDate(const std::optional<std::string> &date, const Language &language);

/// A page of fields in sections, filled from the document without signals. Texts of labels are sources of the
/// context given.
class Form : public QWidget {
    Q_OBJECT

public:
    using Value = std::function<QString(const FormSource &)>;

    /// `context`: of the labels, the name of the page's class. `page`: whose missing statements are marked.
    Form(const char *context, Page page, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Moves the focus to the field of a finding; false: it has none here.
    bool focusField(const QString &id);
    /// Moves the focus to fields that are chosen while the page is in view.
    void follow(Selection &selection);

protected:
    // Building, in the constructor or in prepare(). Labels are marked for translation with QT_TRANSLATE_NOOP
    // of the context.
    void addSection(const char *title);
    /// Begins a row; its fields share the width by their weights.
    void beginRow();
    /// `key`: id of the findings that say it is missing, which is the key in the file; empty: never asked
    /// for.
    Field *addText(const char *key, const char *label, Value value, int weight = 1);
    Field *addNumber(const char *key, const char *label, const QString &unit, Value value, int weight = 1);
    void addStretch();
    void clear(); ///< removes everything that was added
    [[nodiscard]] const EvaluatedDocument &evaluated() const { return m_evaluated; }
    [[nodiscard]] std::size_t test() const { return m_test; }
    [[nodiscard]] const Language &language() const { return m_language; }

    /// Called before the fields are filled, for pages whose fields depend on the document.
    virtual void prepare() {}
    /// The words of the chip at the top; empty: no chip.
    [[nodiscard]] virtual QString missingText(int count) const;

    void refresh();
    void changeEvent(QEvent *event) override;

private:
    struct Entry {
        Field *field;
        const char *key;
        const char *label;
        Value value;
    };
    struct Title {
        QLabel *shown;
        const char *source;
    };

    Field *add(Field::Kind kind, const char *key, const char *label, const QString &unit, Value value,
               int weight);
    [[nodiscard]] bool isMissingHere(const char *key) const;

    const char *m_context;
    Page m_page;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    Chip *m_chip;
    QScrollArea *m_scroll;
    QVBoxLayout *m_body;
    QGridLayout *m_row = nullptr;
    int m_column = 0;
    std::vector<Entry> m_entries;
    std::vector<Title> m_titles;
};

} // namespace palmer::ui
