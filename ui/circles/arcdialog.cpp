// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arcdialog.h"

#include "document/documenterror.h"
#include "import/choices.h"
#include "import/layouts/arcs.h"
#include "kernel/words/shortest.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "tables/units.h"
#include "ui/circles/arctexts.h"
#include "ui/formrows.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/remarklist.h"
#include "ui/tabletext.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTimer>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int sideWidth = 300;
constexpr int fewestLines = 3;
constexpr int remarksHeight = 132;

/// The entry of the first box is what the table says.
bool isOpen(const QComboBox &box) {
    return box.currentData().toString().isEmpty();
}

/// A choice of the import as it is said to people.
QString wordOf(const char *key, const std::string &word) {
    const Argument name = nameOfWord(key, word);
    const auto *text = std::get_if<Text>(&name);
    return text ? windowLanguage().text(*text) : QString::fromStdString(word);
}

/// Chooses without reading anew; false: the box has no such entry.
bool choose(QComboBox &box, const std::string &word) {
    const int entry = box.findData(QString::fromStdString(word));
    const QSignalBlocker blocker(box);
    if (entry >= 0)
        box.setCurrentIndex(entry);
    return entry >= 0;
}

} // namespace

ArcDialog::ArcDialog(CircularMeasurement circle, const Language &language, const QString &text,
                     QWidget *parent)
    : QDialog(parent)
    , m_circle(std::move(circle))
    , m_language(language)
    , m_text(made<TableText>("arcTable", this))
    , m_problem(made<QLabel>("arcProblem", trait::reason, trait::wrapped, trait::plainText, this))
    , m_paths(made<QLabel>("arcPaths", trait::wrapped, trait::plainText, this))
    , m_remarks(made<RemarkList>("arcRemarks", this))
    , m_remarksPlace(new QScrollArea(this)) {
    setObjectName(QStringLiteral("arcDialog"));
    setWindowTitle(tr("New arc"));
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setTabChangesFocus(true);
    const QString example = QStringLiteral("\n0\t1.2\n0.5\t1.3\n…\n")
                                .replace(u'.', language.id() == Language::Id::french ? u',' : u'.');
    m_text->setPlaceholderText(tr("One point a line, for example angle and radial deviation:") + example +
                               tr("Headings may name columns, units and sense."));
    auto *label = new QLabel(tr("&Table of points"), this);
    label->setBuddy(m_text);
    m_remarks->setAccessibleName(tr("Questions and remarks"));
    m_remarksPlace->setAccessibleName(m_remarks->accessibleName());
    m_remarksPlace->setWidget(m_remarks);
    m_remarksPlace->setWidgetResizable(true);
    m_remarksPlace->setFrameShape(QFrame::NoFrame);
    m_remarksPlace->setFixedHeight(remarksHeight);

    auto *side = new QWidget(this);
    side->setFixedWidth(sideWidth);
    inColumn(side, noMargins, 12, {makeForm(), m_problem, m_paths, Placed::stretch()});
    auto *left = inColumn(4, {label, {m_text, 1}});
    auto *body = inRow(16, {{left, 1}, side});
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_add = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
    m_add->setObjectName(QStringLiteral("addArcs"));
    makePrimary(*m_add);
    m_confirmAll = buttons->addButton(tr("Con&firm all"), QDialogButtonBox::ActionRole);
    m_confirmAll->setObjectName(QStringLiteral("confirmAll"));
    m_confirmAll->setAutoDefault(false);
    inColumn(this, {pageMargin, pageMargin, pageMargin, pageMargin}, 16,
             {{body, 1}, m_remarksPlace, buttons});
    resize(720, 600);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_text->setPlainText(text);
    connect(m_remarks, &RemarkList::answered, this, &ArcDialog::answer);
    connect(m_remarks, &RemarkList::answerWanted, m_content, [this] { m_content->setFocus(); });
    connect(m_confirmAll, &QPushButton::clicked, this, &ArcDialog::confirmAll);
    // Answers hold only for the numbers they were given for.
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] { m_answers.clear(); });
    for (const QComboBox *box : m_choices)
        connect(box, &QComboBox::currentIndexChanged, this, [this] { m_answers.clear(); });
    connect(m_text, &QPlainTextEdit::textChanged, this, &ArcDialog::read);
    for (const QComboBox *box : findChildren<QComboBox *>())
        connect(box, &QComboBox::currentIndexChanged, this, &ArcDialog::read);
    read();
}

QFormLayout *ArcDialog::makeForm() {
    auto *form = new QFormLayout;
    m_content = addChoice(*form, "arcContent", tr("Co&lumns"));
    fillWords(*m_content, "layout", isLayoutOfCircles);
    fillWords(*addChoice(*form, "arcUnit", tr("&Unit")), "unit",
              [](std::string_view word) { return unitOf(word)->kind == UnitKind::length; });
    fillWords(*addChoice(*form, "arcMark", tr("&Decimal mark")), "decimalMark",
              [](std::string_view) { return true; });
    m_sense = addChoice(*form, "arcSense", tr("&Sense"));
    m_sense->addItem(tr("as recognised"));
    for (const Sense sense : {Sense::counterclockwise, Sense::clockwise})
        m_sense->addItem(senseWord(sense), static_cast<int>(sense));
    m_reference = addChoice(*form, "arcReference", tr("An&gles"));
    for (const ImportWord &word : findImportKey("angleReference")->words)
        m_reference->addItem(windowLanguage().text(word.name), QString::fromLatin1(word.word));
    if (!m_circle.arcs.empty())
        m_reference->setCurrentIndex(static_cast<int>(m_circle.arcs.front().angleReference));
    m_start = addAngle(*form, "arcStart", tr("Sta&rt angle"), 0);
    m_way = addAngle(*form, "arcExtent", tr("&Extent of the arc"), 360);

    alignLabels(*form);
    return form;
}

QComboBox *ArcDialog::addChoice(QFormLayout &form, const char *name, const QString &label) {
    auto *box = made<QComboBox>(name, this);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form.addRow(label, box);
    return box;
}

/// A choice of the import: what the table says, or one of these words.
void ArcDialog::fillWords(QComboBox &box, const char *key, bool (*isOfCircle)(std::string_view word)) {
    box.addItem(tr("as recognised"));
    for (const ImportWord &word : findImportKey(key)->words) {
        if (isOfCircle(word.word))
            box.addItem(windowLanguage().text(word.name), QString::fromLatin1(word.word));
    }
    box.setProperty("key", QLatin1StringView(key));
    m_choices.push_back(&box);
}

QLineEdit *ArcDialog::addAngle(QFormLayout &form, const char *name, const QString &label, double value) {
    auto *field = made<QLineEdit>(name, m_language.number(certain(value), Quantity::angle), this);
    field->setAlignment(Qt::AlignRight);
    auto *text = new QLabel(label, this);
    text->setBuddy(field);
    form.addRow(text, inRow(styleSpacing, {field, new QLabel(QStringLiteral("°"), this)}));
    connect(field, &QLineEdit::textChanged, this, [this] {
        m_answers.erase("arc"); // what was confirmed was another extent
        read();
    });
    return field;
}

bool ArcDialog::looksLikePoints(const QString &text) {
    static const QRegularExpression pointLine(
        QStringLiteral("^[ \\t]*[-+\u2212]?[0-9][-+0-9.,;|eE\u2212 \\t]*$"),
        QRegularExpression::MultilineOption);
    int lines = 0;
    for (auto found = pointLine.globalMatch(text); found.hasNext() && lines < fewestLines; ++lines)
        found.next();
    return lines >= fewestLines;
}

ArcTable ArcDialog::readTable(const std::string &text) const {
    ImportOptions answers = m_answers;
    for (const QComboBox *box : m_choices) {
        if (!isOpen(*box))
            answers[box->property("key").toString().toStdString()] =
                box->currentData().toString().toStdString();
    }
    answers["angleReference"] = m_reference->currentData().toString().toStdString();
    const auto numberIn = [](const QLineEdit &field) {
        return enteredNumber(field.text(), Quantity::angle).value.value_or(0);
    };
    answers["startAngle"] = shortest(numberIn(*m_start));
    const double extent = numberIn(*m_way);
    std::optional<Sense> sense;
    if (!isOpen(*m_sense)) {
        sense = static_cast<Sense>(m_sense->currentData().toInt());
        answers["arc"] = shortest(sense == Sense::clockwise ? -extent : extent);
    }
    return readArcTable(text, m_circle, answers, sense, {{"arc", shortest(extent)}});
}

void ArcDialog::answer(const QString &id, const QString &word) {
    const std::string key = id.toStdString();
    const auto asked = std::ranges::find(m_questions, key, &Question::id);
    if (asked != m_questions.end() && !asked->proposal.empty() && asked->proposal != word.toStdString())
        m_answers.clear(); // the numbers become others
    const auto box = std::ranges::find_if(
        m_choices, [&](const QComboBox *each) { return each->property("key").toString() == id; });
    if (box == m_choices.end() || !choose(**box, word.toStdString()))
        m_answers[key] = word.toStdString();
    read();
    // The pressed button disappears, and new ones are shown only after the event.
    QTimer::singleShot(0, this, [this] {
        if (m_add->isEnabled())
            return m_add->setFocus();
        const QList<QPushButton *> buttons = m_remarks->findChildren<QPushButton *>();
        const auto next =
            std::ranges::find_if(buttons, [](const auto *button) { return button->isVisible(); });
        if (next != buttons.end())
            (*next)->setFocus();
    });
}

/// Confirms only the current questions: an answer may raise another, which must be read first.
void ArcDialog::confirmAll() {
    const std::vector<Question> asked = m_questions;
    for (const Question &question : asked) {
        if (canBeConfirmed(question))
            answer(QString::fromStdString(question.id), QString::fromStdString(question.proposal));
    }
}

void ArcDialog::read() {
    m_arcs.clear();
    m_questions.clear();
    const QString text = m_text->toPlainText();
    if (text.trimmed().isEmpty()) {
        showProblem({});
        return;
    }
    if (!(enteredNumber(m_way->text(), Quantity::angle).value.value_or(0) > 0)) {
        showProblem(tr("The extent of an arc is a number of degrees above 0."));
        return;
    }
    try {
        ArcTable table = readTable(text.toStdString());
        m_arcs = std::move(table.arcs);
        m_questions = table.questions;
        showTable(table);
    } catch (const Error &error) {
        QString problem = m_language.sentence(error.message);
        if (!error.place.empty())
            problem = QString::fromStdString(error.place) + QStringLiteral(": ") + problem;
        showProblem(problem);
    }
}

void ArcDialog::showTable(const ArcTable &table) {
    const auto chosen = [&](const char *key) {
        const auto choice = std::ranges::find(table.choices, key, &ImportChoice::key);
        return choice == table.choices.end() ? std::string() : choice->value;
    };
    const bool alone = chosen("layout") == "deviations";
    m_start->setEnabled(alone);
    m_way->setEnabled(alone);
    const auto questions = static_cast<int>(m_questions.size());
    m_problem->setText(tr("%n question(s) to answer", nullptr, questions));
    m_problem->setVisible(questions > 0);
    QStringList paths{tr("read as %1, in %2", "columns, unit")
                          .arg(wordOf("layout", chosen("layout")), wordOf("unit", chosen("unit")))};
    for (const Arc &arc : m_arcs)
        paths << tr("%1, %2 points: %3 … %4", "sense of a path")
                     .arg(senseWord(arc.sense),
                          m_language.number(static_cast<double>(arc.angles.size()), Quantity::count, 0),
                          m_language.quantity(arc.angles.front(), Quantity::angle, 1),
                          m_language.quantity(arc.angles.back(), Quantity::angle, 1));
    m_paths->setText(paths.join(u'\n'));
    m_paths->show();
    Imported shown;
    shown.questions = table.questions;
    shown.remarks = table.remarks;
    m_remarks->showRemarks(shown, std::nullopt, [](std::size_t) { return false; });
    m_remarksPlace->setVisible(!shown.questions.empty() || !shown.remarks.empty());
    m_confirmAll->setVisible(std::ranges::count_if(m_questions, canBeConfirmed) > 1);
    const auto points = static_cast<int>(table.points);
    m_add->setText(withGroups(tr("&Add %n point(s)", nullptr, points), points));
    m_add->setEnabled(m_questions.empty());
}

void ArcDialog::showProblem(const QString &problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_paths->hide();
    m_remarksPlace->hide();
    m_confirmAll->hide();
    m_add->setText(tr("&Add"));
    m_add->setEnabled(false);
}

} // namespace palmer::ui
