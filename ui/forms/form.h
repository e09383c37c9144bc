// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "document/statedthings.h"
#include "language/entry.h"
#include "language/language.h"
#include "ui/forms/field.h"
#include "ui/forms/member.h"
#include "ui/forms/refusedfields.h"
#include "ui/model/selection.h"

#include <QScrollArea>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace palmer::ui {

class Chip;
class ColumnsLayout;
class DocumentModel;
class SectionHead;

// What is stated, as fields show it; empty for what is not.
[[nodiscard]] QString stated(const std::string &text);
[[nodiscard]] QString stated(const std::optional<double> &value, Quantity quantity, const Language &language);
[[nodiscard]] QString statedDate(const std::optional<std::string> &date, const Language &language);

/// A page of fields in sections, filled from the document without signals. What is typed changes the document
/// at once, as one step to undo for every visit of a field. Texts of labels are sources of the context given.
class Form : public QWidget {
    Q_OBJECT

public:
    /// `context`: of the labels, the name of the page's class. `page`: whose missing statements are marked.
    Form(const char *context, Page page, DocumentModel &model, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Moves the focus to the field of a finding; false: it has none here.
    virtual bool focusField(const QString &id);
    /// The same by the label of the field, as in EditPlace.
    bool focusLabel(const QByteArray &label, const QString &argument);
    /// Moves the focus to the first field, as Tab does; nothing on a page without fields.
    void focusFirst();
    /// Moves the focus to the next field that is required and empty, or the one before; false: there is none
    /// between the field the focus came to last and the end of the page (or its beginning).
    virtual bool focusNextRequired(bool forward);
    /// The walk begins at the first field again.
    void startOver() { m_place.reset(); }
    /// Puts the page behind that widget in the order of Tab.
    void chainAfter(QWidget *before);
    /// What was typed here, for any test, and cannot be taken.
    [[nodiscard]] QStringList refusedTexts() const;
    /// Moves the focus to fields that are chosen while the page is in view.
    void follow(Selection &selection);

signals:
    /// The next missing statement is asked for.
    void nextWanted();

protected:
    using Amount = std::optional<double>;
    using Moment = std::optional<std::string>;
    /// What the file format demands of a number.
    enum class Allowed { any, notNegative, positive, whole, counting, celsius, coefficient };

    /// The StatedThing that a field shows. Its name is the label unless another is given; its key is the id
    /// of the findings that say it is missing (empty: never asked for).
    struct Topic {
        // NOLINTNEXTLINE(google-explicit-constructor): as it is written in the pages
        Topic(const char *thing);
        Topic(const char *thing, const char *name)
            : key(thing)
            , label(name) {}

        const char *key;
        const char *label;
    };

    // Building, in the constructor or in prepare(). Labels are marked for translation with QT_TRANSLATE_NOOP
    // of the context.
    void addSection(const char *title, const QString &argument = {});
    /// A section that is folded where all that it must state is stated, when the page comes into view: never
    /// while it is looked at. `summary`: what the folded one says in a line; without it the values in it.
    void addFoldingSection(const char *title, std::function<QString()> summary = {});
    /// The section added last is not complete while that is missing, for which it has no field.
    void sectionNeeds(const char *key) { m_sections.back().needs.push_back(key); }
    /// A button at the right of the title added last.
    QPushButton *addSectionButton(const char *text, std::function<void()> pressed);
    /// Something else at the right of the title added last.
    void addToSection(QWidget *widget, int stretch = 0);
    /// Begins a row; its fields share the width by their weights.
    void beginRow();
    /// Begins a row of twelve columns, which are the same in all of them; a weight is a number of columns.
    void beginColumns();
    Field *addText(const Topic &topic, Member<std::string> member, int weight = 1,
                   Field::Kind kind = Field::Kind::text);
    Field *addLongText(const Topic &topic, Member<std::string> member, int weight = 1);
    /// `unit`: empty takes that of the quantity.
    Field *addNumber(const Topic &topic, Quantity quantity, Member<Amount> member, int weight = 1,
                     Allowed allowed = Allowed::any);
    Field *addInterval(const Topic &topic, Quantity quantity, Member<std::optional<Interval>> member,
                       int weight = 1);
    Field *addDate(const Topic &topic, Member<Moment> member, int weight = 1);
    Field *addTime(const Topic &topic, Member<Moment> member, int weight = 1);
    /// `none`: the first word says that nothing is stated.
    Field *addChoice(const Topic &topic, const std::vector<const char *> &words, Member<int> member,
                     bool none, int weight = 1);
    /// Among the words of the thing; its first one may say nothing.
    template <class Enumeration>
    Field *addWords(const char *thing, Member<Enumeration> member, int weight = 1) {
        return addWordsOf(thing,
                          converted<std::size_t, Enumeration>(
                              std::move(member),
                              [](const Enumeration &word) { return static_cast<std::size_t>(word); },
                              [](const std::size_t &place) { return static_cast<Enumeration>(place); }),
                          weight);
    }
    /// What the test in view or its conditions say under the key of the thing; null: tests of its kind have
    /// no such key.
    Field *addThing(const char *thing, int weight = 1);
    /// All things of a section in rows of twelve columns, of the first of which so many are taken.
    void addThings(FieldForm::Section section, int taken = 12);
    Field *addYesNo(const Topic &topic, Member<std::optional<bool>> member, int weight = 1);
    /// A button below the rows, or in one.
    QPushButton *addButton(const char *text, std::function<void()> pressed, int weight = 1);
    void addWidget(QWidget *widget, int weight = 1);
    void addStretch();
    void showPart(QWidget &part); ///< scrolls to it
    /// Brings a field into view and the focus to it.
    void focusPart(Field &field);
    void addToBar(QWidget *widget); ///< at the right of the bar above the page
    void clear();                   ///< removes everything that was added but for the bar

    /// Changes the document as one step; `name` is a source of the context "edits".
    void edit(const char *name, const std::function<void(Document &)> &change, const QString &mergeKey = {});

    [[nodiscard]] const EvaluatedDocument &evaluated() const { return m_evaluated; }
    [[nodiscard]] std::size_t test() const { return m_test; }
    /// The test in view; null where there is none.
    [[nodiscard]] const Test *shownTest() const;
    [[nodiscard]] const Language &language() const { return m_language; }
    [[nodiscard]] QString word(const char *source, const char *comment = nullptr) const;
    /// The parent of what is added next.
    [[nodiscard]] QWidget *body() const;

    /// Called before the fields are filled, for pages whose fields depend on the document.
    virtual void prepare() {}
    /// Called after the fields are filled.
    virtual void refreshOthers() {}
    /// The words of the chip at the top; empty: no chip.
    [[nodiscard]] virtual QString missingText(int count) const;

    void refresh();
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    using Change = std::function<void(Document &)>;

    struct Entry {
        Field *field = nullptr;
        const char *key = nullptr;
        const char *label = nullptr;
        std::optional<Quantity> quantity;                 ///< of a number: its unit may change
        std::vector<Text> words;                          ///< of a choice
        bool none = false;                                ///< the first of them states nothing
        std::function<QString(const FormSource &)> value; ///< of all but choices
        std::function<int(const FormSource &)> choice;
        std::function<Change()> change; ///< made of what is in the field now
    };
    struct Title {
        QLabel *shown = nullptr;
        const char *source = nullptr;
        QString argument;
    };
    struct Button {
        QPushButton *shown = nullptr;
        const char *source = nullptr;
    };
    /// Of fields from `begin` to that of the next section.
    struct Section {
        SectionHead *head = nullptr; ///< null: it does not fold
        QWidget *content = nullptr;
        const char *title = nullptr;
        std::function<QString()> summary;
        std::vector<const char *> needs;
        std::vector<QWidget *> atHead; ///< seen while it is open
        std::size_t begin = 0;
    };

    [[nodiscard]] static unsigned boundsOf(Allowed allowed); ///< Demand
    Field *addWordsOf(const char *thing, Member<std::size_t> member, int weight);
    Field *addChoiceOf(const Topic &topic, std::vector<Text> words, Member<int> member, bool none,
                       int weight);
    Field *add(Field::Kind kind, const Topic &topic, const QString &unit, int weight);
    Entry &last() { return m_entries.back(); }
    void commit(const Field *field);
    void refreshTexts();
    void keepRefused();
    void chainFields();
    void removeItems(class QLayout &layout);
    void addToPlace(QLayout *row);
    [[nodiscard]] QWidget *page() const { return m_scroll->widget(); }
    [[nodiscard]] std::span<const Entry> fieldsOf(const Section &section) const;
    [[nodiscard]] int countMissingIn(const Section &section) const;
    [[nodiscard]] bool isComplete(const Section &section) const;
    [[nodiscard]] QString valuesOf(const Section &section) const;
    static void fold(const Section &section, bool folded);
    void foldComplete();
    void unfoldAround(const QWidget &part);
    void refreshSummaries();
    [[nodiscard]] bool isMissingHere(const char *key) const;

    const char *m_context;
    Page m_page;
    DocumentModel &m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    QString m_of; ///< id of the test the fields show; empty outside of tests
    RefusedFields m_refused;
    Language m_language{Language::Id::english};
    Chip *m_chip;
    QPushButton *m_next;
    QHBoxLayout *m_bar;
    QScrollArea *m_scroll;
    QVBoxLayout *m_body;
    QHBoxLayout *m_head = nullptr; ///< of the section added last
    QGridLayout *m_row = nullptr;
    int m_column = 0;
    ColumnsLayout *m_columns = nullptr; ///< of the row, where it has twelve
    std::vector<Section> m_sections;
    std::map<std::string, bool> m_folded; ///< by title, of the sections that stood there before
    std::map<std::string, bool> m_chosen; ///< what the user folded or unfolded in this test
    bool m_isFoldDue = false;             ///< the page came into view, or shows another test
    bool m_isRebuilt = true;              ///< the fields came after others in the order of Tab
    bool m_isStale = false;               ///< not filled since the document changed: out of view
    int m_visit = 0;                      ///< counts the fields the focus came to
    std::optional<std::size_t> m_place;   ///< of the field the focus came to last while the page is in view
    QString m_focused;
    std::vector<Entry> m_entries;
    std::vector<Title> m_titles;
    std::vector<Button> m_buttons;
};

} // namespace palmer::ui
