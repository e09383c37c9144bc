// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arcdialog.h"

#include "document/documenterror.h"
#include "language/entry.h"
#include "tables/units.h"
#include "ui/circles/arctexts.h"
#include "ui/dialogs/formrows.h"
#include "ui/remarklist.h"
#include "ui/tabletext.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTimer>
#include <algorithm>
#include <array>
#include <span>

namespace palmer::ui {

namespace {

constexpr std::array units{"mm", "um", "nm", "in", "uin"};
constexpr int sideWidth = 300;
constexpr int fewestLines = 3;
constexpr int remarksHeight = 132;
// Answers to questions of the import, in the order of the boxes.
constexpr std::array layouts{"angleDeviation", "angleRadius", "xy"};
constexpr std::array marks{"point", "comma"};

/// The word chosen; the first entry leaves it to the table.
template <class Value>
std::optional<Value> chosen(const QComboBox *box) {
    return box->currentIndex() > 0 ? std::optional(static_cast<Value>(box->currentIndex() - 1))
                                   : std::nullopt;
}

/// Chooses without reading anew; false: the box has no such entry.
bool choose(QComboBox *box, std::span<const char *const> words, const std::string &word) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        return false;
    const QSignalBlocker blocker(box);
    box->setCurrentIndex(static_cast<int>(found - words.begin()) + 1);
    return true;
}

} // namespace

ArcDialog::ArcDialog(CircularMeasurement circle, const Language &language, const QString &text,
                     QWidget *parent)
    : QDialog(parent)
    , m_circle(std::move(circle))
    , m_language(language)
    , m_text(new TableText(this))
    , m_problem(new QLabel(this))
    , m_paths(new QLabel(this))
    , m_remarks(new RemarkList(this))
    , m_remarksPlace(new QScrollArea(this)) {
    setObjectName(QStringLiteral("arcDialog"));
    setWindowTitle(tr("New arc"));
    m_text->setObjectName(QStringLiteral("arcTable"));
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setTabChangesFocus(true);
    const QString example = QStringLiteral("\n0\t1.2\n0.5\t1.3\n…\n")
                                .replace(u'.', language.id() == Language::Id::french ? u',' : u'.');
    m_text->setPlaceholderText(tr("One point a line, for example angle and radial deviation:") + example +
                               tr("Headings may name columns, units and sense."));
    auto *label = new QLabel(tr("&Table of points"), this);
    label->setBuddy(m_text);
    m_problem->setObjectName(QStringLiteral("arcProblem"));
    m_problem->setProperty("reason", true);
    m_paths->setObjectName(QStringLiteral("arcPaths"));
    m_remarks->setObjectName(QStringLiteral("arcRemarks"));
    m_remarks->setAccessibleName(tr("Questions and remarks"));
    m_remarksPlace->setAccessibleName(m_remarks->accessibleName());
    m_remarksPlace->setWidget(m_remarks);
    m_remarksPlace->setWidgetResizable(true);
    m_remarksPlace->setFrameShape(QFrame::NoFrame);
    m_remarksPlace->setFixedHeight(remarksHeight);
    for (QLabel *each : {m_problem, m_paths}) {
        each->setWordWrap(true);
        each->setTextFormat(Qt::PlainText);
    }

    auto *side = new QWidget(this);
    side->setFixedWidth(sideWidth);
    auto *sideColumn = new QVBoxLayout(side);
    sideColumn->setContentsMargins(0, 0, 0, 0);
    sideColumn->setSpacing(12);
    sideColumn->addLayout(makeForm());
    sideColumn->addWidget(m_problem);
    sideColumn->addWidget(m_paths);
    sideColumn->addStretch();
    auto *left = new QVBoxLayout;
    left->setSpacing(4);
    left->addWidget(label);
    left->addWidget(m_text, 1);
    auto *body = new QHBoxLayout;
    body->setSpacing(16);
    body->addLayout(left, 1);
    body->addWidget(side);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_add = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
    m_add->setObjectName(QStringLiteral("addArcs"));
    makePrimary(*m_add);
    m_confirmAll = buttons->addButton(tr("Con&firm all"), QDialogButtonBox::ActionRole);
    m_confirmAll->setObjectName(QStringLiteral("confirmAll"));
    m_confirmAll->setAutoDefault(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    column->addLayout(body, 1);
    column->addWidget(m_remarksPlace);
    column->addWidget(buttons);
    resize(720, 600);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_text->setPlainText(text);
    connect(m_remarks, &RemarkList::answered, this, &ArcDialog::answer);
    connect(m_remarks, &RemarkList::answerWanted, m_content, [this] { m_content->setFocus(); });
    connect(m_confirmAll, &QPushButton::clicked, this, &ArcDialog::confirmAll);
    // What was confirmed are the numbers as they were.
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] { m_answers.clear(); });
    for (const QComboBox *box : {m_content, m_unit, m_mark})
        connect(box, &QComboBox::currentIndexChanged, this, [this] { m_answers.clear(); });
    connect(m_text, &QPlainTextEdit::textChanged, this, &ArcDialog::read);
    for (const QComboBox *box : {m_content, m_unit, m_mark, m_sense, m_reference})
        connect(box, &QComboBox::currentIndexChanged, this, &ArcDialog::read);
    read();
}

QFormLayout *ArcDialog::makeForm() {
    auto *form = new QFormLayout;
    const QString open = tr("as recognised");
    m_content = addChoice(*form, "arcContent", tr("Co&lumns"),
                          {open, tr("angle, radial deviation"), tr("angle, radius"), tr("x, y"),
                           tr("radial deviations alone")});
    QStringList signs{open};
    for (const char *unit : units)
        signs << QString::fromUtf8(unitOf(unit)->sign);
    m_unit = addChoice(*form, "arcUnit", tr("&Unit"), signs);
    m_mark = addChoice(*form, "arcMark", tr("&Decimal mark"), {open, tr("point"), tr("comma")});
    m_sense = addChoice(*form, "arcSense", tr("&Sense"),
                        {open, senseWord(Sense::counterclockwise), senseWord(Sense::clockwise)});
    m_reference =
        addChoice(*form, "arcReference", tr("An&gles"), {tr("of the point (polar)"), tr("commanded")});
    if (!m_circle.arcs.empty())
        m_reference->setCurrentIndex(static_cast<int>(m_circle.arcs.front().angleReference));
    m_start = addAngle(*form, "arcStart", tr("Sta&rt angle"), 0);
    m_way = addAngle(*form, "arcExtent", tr("&Extent of the arc"), 360);

    alignLabels(*form);
    return form;
}

QComboBox *ArcDialog::addChoice(QFormLayout &form, const char *name, const QString &label,
                                const QStringList &words) {
    auto *box = new QComboBox(this);
    box->setObjectName(QLatin1StringView(name));
    box->addItems(words);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form.addRow(label, box);
    return box;
}

QLineEdit *ArcDialog::addAngle(QFormLayout &form, const char *name, const QString &label, double value) {
    auto *field = new QLineEdit(m_language.number(value, Quantity::angle), this);
    field->setObjectName(QLatin1StringView(name));
    field->setAlignment(Qt::AlignRight);
    auto *text = new QLabel(label, this);
    text->setBuddy(field);
    auto *row = new QHBoxLayout;
    row->addWidget(field);
    row->addWidget(new QLabel(QStringLiteral("°"), this));
    form.addRow(text, row);
    connect(field, &QLineEdit::textChanged, this, &ArcDialog::read);
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

ArcTableChoices ArcDialog::choices() const {
    ArcTableChoices result;
    result.content = chosen<ArcContent>(m_content);
    result.decimalMark = chosen<DecimalMark>(m_mark);
    if (const auto unit = chosen<std::size_t>(m_unit))
        result.unit = units.at(*unit);
    result.sense = chosen<Sense>(m_sense);
    result.angleReference = static_cast<AngleReference>(m_reference->currentIndex());
    result.startAngle = enteredNumber(m_start->text(), Quantity::angle).value.value_or(0);
    result.arc = enteredNumber(m_way->text(), Quantity::angle).value.value_or(0);
    result.answers = m_answers;
    return result;
}

void ArcDialog::answer(const QString &id, const QString &word) {
    const std::string key = id.toStdString();
    const auto asked = std::ranges::find(m_questions, key, &Question::id);
    if (asked != m_questions.end() && !asked->proposal.empty() && asked->proposal != word.toStdString())
        m_answers.clear(); // the numbers become others
    const bool chosen = key == "layout"        ? choose(m_content, layouts, word.toStdString())
                        : key == "unit"        ? choose(m_unit, units, word.toStdString())
                        : key == "decimalMark" ? choose(m_mark, marks, word.toStdString())
                                               : false;
    if (!chosen)
        m_answers[key] = word.toStdString();
    read();
    // The button that was pressed goes, and those that come are shown in the next turn.
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

/// An answer may raise the next question, which has to be read before it is confirmed: once is enough.
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
    const ArcTableChoices asked = choices();
    if (!(asked.arc > 0)) {
        showProblem(tr("The extent of an arc is a number of degrees above 0."));
        return;
    }
    try {
        ArcTable table = readArcTable(text.toStdString(), m_circle, asked);
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
    const bool alone = table.content.value == ArcContent::deviations;
    m_start->setEnabled(alone);
    m_way->setEnabled(alone);
    const auto questions = static_cast<int>(m_questions.size());
    m_problem->setText(tr("%n question(s) to answer", nullptr, questions));
    m_problem->setVisible(questions > 0);
    const Unit *unit = unitOf(table.unit.value);
    QStringList paths{tr("read as %1, in %2", "columns, unit")
                          .arg(m_content->itemText(static_cast<int>(table.content.value) + 1),
                               unit ? QString::fromUtf8(unit->sign) : QString())};
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
