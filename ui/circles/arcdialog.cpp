// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arcdialog.h"

#include "document/documenterror.h"
#include "language/entry.h"
#include "tables/units.h"
#include "ui/circles/arctexts.h"
#include "ui/dialogs/formrows.h"
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
#include <array>

namespace palmer::ui {

namespace {

constexpr std::array units{"mm", "um", "nm", "in", "uin"};
constexpr int sideWidth = 300;
constexpr int fewestLines = 3;

/// The word chosen; the first entry leaves it to the table.
template <class Value>
std::optional<Value> chosen(const QComboBox *box) {
    return box->currentIndex() > 0 ? std::optional(static_cast<Value>(box->currentIndex() - 1))
                                   : std::nullopt;
}

QString gradeMark(RemarkGrade grade) {
    switch (grade) {
    case RemarkGrade::problem:
        return QStringLiteral("⚠ ");
    case RemarkGrade::assumption:
        return QStringLiteral("? ");
    case RemarkGrade::note:
        break;
    }
    return QStringLiteral("· ");
}

} // namespace

ArcDialog::ArcDialog(CircularMeasurement circle, const Language &language, const QString &text,
                     QWidget *parent)
    : QDialog(parent)
    , m_circle(std::move(circle))
    , m_language(language)
    , m_text(new QPlainTextEdit(this))
    , m_problem(new QLabel(this))
    , m_paths(new QLabel(this))
    , m_remarks(new QLabel(this)) {
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
    m_remarks->setProperty("secondary", true);
    for (QLabel *each : {m_problem, m_paths, m_remarks}) {
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
    sideColumn->addWidget(m_remarks);
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
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    column->addLayout(body, 1);
    column->addWidget(buttons);
    resize(720, 480);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_text->setPlainText(text);
    connect(m_text, &QPlainTextEdit::textChanged, this, &ArcDialog::read);
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
    connect(box, &QComboBox::currentIndexChanged, this, &ArcDialog::read);
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
    return result;
}

void ArcDialog::read() {
    m_arcs.clear();
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
    m_problem->hide();
    QStringList paths;
    for (const Arc &arc : m_arcs)
        paths << tr("%1, %2 points: %3 … %4", "sense of a path")
                     .arg(senseWord(arc.sense),
                          m_language.number(static_cast<double>(arc.angles.size()), Quantity::count, 0),
                          m_language.quantity(arc.angles.front(), Quantity::angle, 1),
                          m_language.quantity(arc.angles.back(), Quantity::angle, 1));
    m_paths->setText(paths.join(u'\n'));
    m_paths->show();
    QStringList remarks;
    for (const Remark &remark : table.remarks) {
        QString line = gradeMark(remark.grade) + m_language.sentence(remark.message);
        if (remark.line > 0)
            line += QStringLiteral(" (") + tr("line %1").arg(remark.line) + u')';
        remarks << line;
    }
    m_remarks->setText(remarks.join(u'\n'));
    m_remarks->setVisible(!remarks.isEmpty());
    const auto points = static_cast<int>(table.points);
    m_add->setText(withGroups(tr("&Add %n point(s)", nullptr, points), points));
    m_add->setEnabled(true);
}

void ArcDialog::showProblem(const QString &problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_paths->hide();
    m_remarks->hide();
    m_add->setText(tr("&Add"));
    m_add->setEnabled(false);
}

} // namespace palmer::ui
