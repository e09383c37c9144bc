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
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QScrollArea>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palmer::ui {

class LinkChip;
class ColumnsLayout;
class GroupLayout;
class DocumentModel;
class SectionHead;

// Statements as shown in fields; empty if not stated.
[[nodiscard]] QString stated(const std::string &text);
[[nodiscard]] QString stated(const std::optional<double> &value, Quantity quantity, const Language &language);
[[nodiscard]] QString statedDate(const std::optional<std::string> &date, const Language &language);

/// A page of fields in sections, filled from the document without signals. Typing changes the document at
/// once, as one undo step per visit of a field. Label texts are sources of the given context. Over 500
/// lines: every kind of row of all pages is made here, so that the pages are lists of rows.
class Form : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    /// `context`: translation context of the labels, the class name of the page. `page`: the one whose
    /// missing statements are marked.
    Form(const char *context, Page page, DocumentModel &model, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Focuses the field of a finding. False if it has none here.
    virtual bool focusField(const QString &id);
    /// The same by the field's label, as in EditPlace.
    bool focusLabel(const QByteArray &label, const QString &argument);
    /// Focuses the first field, as Tab does; does nothing on a page without fields.
    void focusFirst();
    /// Focuses the next or previous field that is required and empty. False if there is none from the last
    /// focused field to the end (or beginning) of the page.
    virtual bool focusNextRequired(bool forward);
    /// Makes focusNextRequired start at the first field again.
    void startOver() { m_place.reset(); }
    /// Places the page after that widget in the tab order.
    void chainAfter(QWidget *before);
    /// Texts typed here, for any test, that cannot be accepted.
    [[nodiscard]] QStringList refusedTexts() const;
    /// A field as a search shows it.
    struct Found {
        QString name;
        QString value;
        bool isMissing = false;
        QPointer<Field> field;
    };
    [[nodiscard]] std::vector<Found> found();
    [[nodiscard]] Page pageShown() const { return m_page; }
    /// Brings a field into view and focuses it.
    void focusPart(Field &field);
    /// Focuses fields that are chosen while the page is in view.
    void follow(Selection &selection);

signals:
    /// The user asked for the next missing statement.
    void nextWanted();

protected:
    using Amount = std::optional<double>;
    using Moment = std::optional<std::string>;
    /// Range of a number in the file format.
    enum class Allowed { any, notNegative, positive, whole, counting, celsius, coefficient, percentage };

    /// The StatedThing shown by a field. Its name is the label unless another is given; its key is the ID of
    /// the findings that report it as missing (empty: never required).
    struct Topic {
        // NOLINTNEXTLINE(google-explicit-constructor): as it is written in the pages
        Topic(const char *thing);
        Topic(const char *thing, const char *name)
            : key(thing)
            , label(name) {}

        const char *key;
        const char *label;
    };

    // Building, in the constructor or in prepare(). Labels are marked for translation with QT_TR_NOOP.
    void addSection(const char *title, const QString &argument = {});
    /// A section that is folded if complete when the page comes into view, but never while in view.
    /// `summary`: text of the folded section in one line; by default its values.
    void addFoldingSection(const char *title, std::function<QString()> summary = {});
    /// Adds a button on the right of the last title.
    QPushButton *addSectionButton(const char *text, std::function<void()> pressed);
    /// Adds a widget on the right of the last title.
    void addToSection(QWidget *widget, int stretch = 0);
    /// Begins a row whose fields share the width by weight.
    void beginRow();
    /// Begins a row of twelve columns, aligned in all rows; weights are numbers of columns.
    void beginColumns();
    /// Begins a group: its name on the left, its fields in as many rows of twelve columns as they need.
    void beginGroup(const char *name);
    /// Adds a row to the group.
    void addToGroup(QLayout *row);
    Field *addText(const Topic &topic, Member<std::string> member, int weight = 1,
                   Field::Kind kind = Field::Kind::text);
    Field *addLongText(const Topic &topic, Member<std::string> member, int weight = 1);
    /// `unit`: if empty, that of the quantity.
    Field *addNumber(const Topic &topic, Quantity quantity, Member<Amount> member, int weight = 1,
                     Allowed allowed = Allowed::any);
    Field *addInterval(const Topic &topic, Quantity quantity, Member<std::optional<Interval>> member,
                       int weight = 1);
    Field *addDate(const Topic &topic, Member<Moment> member, int weight = 1);
    Field *addTime(const Topic &topic, Member<Moment> member, int weight = 1);
    /// `none`: the first choice means not stated.
    Field *addChoice(const Topic &topic, const std::vector<const char *> &words, Member<int> member,
                     bool none, int weight = 1);
    /// A choice among the values of the thing; the first may mean not stated.
    template <class Enumeration>
    Field *addWords(const Topic &topic, Member<Enumeration> member, int weight = 1) {
        return addWordsOf(topic,
                          converted<std::size_t, Enumeration>(
                              std::move(member),
                              [](const Enumeration &word) { return static_cast<std::size_t>(word); },
                              [](const std::size_t &place) { return static_cast<Enumeration>(place); }),
                          weight);
    }
    /// The statement of the test in view or its conditions under the thing's key; null if its kind has none.
    Field *addThing(const Topic &topic, int weight = 1);
    Field *addYesNo(const Topic &topic, Member<std::optional<bool>> member, int weight = 1,
                    Field::Kind kind = Field::Kind::choice);
    /// A button below the rows or within a row.
    QPushButton *addButton(const char *text, std::function<void()> pressed, int weight = 1);
    /// A button that looks like a link, to be placed by the caller.
    QPushButton *addLink(const char *text, std::function<void()> pressed);
    /// Yes, no or not stated, as a check box.
    Field *addAnswer(const Topic &topic, int weight = 1);
    void addWidget(QWidget *widget, int weight = 1);
    void addStretch();
    void showPart(QWidget &part);   ///< scrolls to it
    void addToBar(QWidget *widget); ///< on the right of the bar above the page
    void clear();                   ///< removes everything added except the bar

    /// Changes the document as one undo step; `name` is a source of the context "edits".
    void edit(const char *name, const std::function<void(Document &)> &change, const QString &mergeKey = {});

    [[nodiscard]] const EvaluatedDocument &evaluated() const { return m_evaluated; }
    [[nodiscard]] std::size_t test() const { return m_test; }
    /// The test in view; may be null.
    [[nodiscard]] const Test *shownTest() const;
    [[nodiscard]] const Language &language() const { return m_language; }
    [[nodiscard]] QString word(const char *source, const char *comment = nullptr) const;
    /// Parent of the widgets added next.
    [[nodiscard]] QWidget *body() const;

    /// Called before the fields are filled, for pages whose fields depend on the document.
    virtual void prepare() {}
    /// Called after the fields are filled.
    virtual void refreshOthers() {}
    /// Text of the chip at the top; empty hides it.
    [[nodiscard]] virtual QString missingText(int count) const;

    void refresh();
    void retranslate() final { refresh(); }
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    using Change = std::function<void(Document &)>;

    struct Entry {
        Field *field = nullptr;
        const char *key = nullptr;
        const char *label = nullptr;
        std::optional<Quantity> quantity;                 ///< of a number, as its unit may change
        std::vector<Text> words;                          ///< of a choice
        bool none = false;                                ///< the first of them means not stated
        std::function<QString(const FormSource &)> value; ///< for all but choices
        std::function<int(const FormSource &)> choice;
        std::function<Change()> change; ///< made from the current content of the field
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
    /// Contains the fields from `begin` up to that of the next section.
    struct Section {
        SectionHead *head = nullptr; ///< null if not foldable
        QWidget *content = nullptr;
        const char *title = nullptr;
        std::function<QString()> summary;
        std::vector<QWidget *> atHead; ///< visible while unfolded
        std::size_t begin = 0;
    };

    /// Why a number cannot be entered; empty if it can.
    [[nodiscard]] QString refusalOf(double value, Allowed allowed) const;
    Field *addWordsOf(const Topic &topic, Member<std::size_t> member, int weight);
    Field *addChoiceOf(const Topic &topic, std::vector<Text> words, Member<int> member, bool none, int weight,
                       Field::Kind kind = Field::Kind::choice);
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
    void offerCalendar(Field &field);
    [[nodiscard]] static QString usualText(int count);
    void markWhatIsMissing(const std::vector<bool> &isEmpty);
    bool focusNext(bool forward, bool (Field::*isMarked)() const);

    const char *m_context;
    Page m_page;
    DocumentModel &m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    QString m_of; ///< ID of the test in the fields; empty outside tests
    RefusedFields m_refused;
    Language m_language{Language::Id::english};
    LinkChip *m_chip;  ///< leads to the next missing statement
    LinkChip *m_usual; ///< what only practice asks for
    QHBoxLayout *m_bar;
    QScrollArea *m_scroll;
    QVBoxLayout *m_body;
    QHBoxLayout *m_head = nullptr; ///< of the last section
    QGridLayout *m_row = nullptr;
    int m_column = 0;
    ColumnsLayout *m_columns = nullptr; ///< of the row, if it has twelve
    GroupLayout *m_group = nullptr;     ///< to which the row belongs
    QVBoxLayout *m_groups = nullptr;    ///< the group and those above it
    std::vector<Section> m_sections;
    std::map<std::string, bool> m_folded; ///< by title, for sections that existed before a rebuild
    std::map<std::string, bool> m_chosen; ///< folded or unfolded by the user in this test
    bool m_isFoldDue = false;             ///< the page came into view or shows another test
    bool m_isRebuilt = true;              ///< fields were replaced: update the tab order
    bool m_isStale = false;               ///< out of view and not filled since the document changed
    int m_visit = 0;                      ///< counts how often a field was focused
    std::optional<std::size_t> m_place;   ///< index of the last focused field while the page is in view
    QString m_focused;
    std::vector<Entry> m_entries;
    std::vector<Title> m_titles;
    std::vector<Button> m_buttons;
};

} // namespace palmer::ui
