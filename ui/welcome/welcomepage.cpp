// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/welcomepage.h"

#include "import/formats.h"
#include "kernel/evaluation/edition.h"
#include "ui/languageswitch.h"
#include "ui/madewidgets.h"
#include "ui/theme.h"
#include "ui/welcome/examples.h"
#include "ui/welcome/recentfiles.h"
#include "ui/welcome/startbutton.h"
#include "ui/windowlanguage.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>

namespace palmer::ui {

namespace {

constexpr int contentWidth = 1216;
constexpr int mostRecent = 12;

QString kindIcon(bool circular) {
    return circular ? QStringLiteral("circle") : QStringLiteral("axis");
}

/// "ISO 230-2 · 1988, 1997, 2006, 2014": editions for evaluating a new test of the kind.
QString standardOf(Kind kind) {
    QString standard;
    QStringList years;
    for (const Edition *edition : editionsOf(kind)) {
        const QString word = QString::fromUtf8(edition->word);
        if (!word.startsWith(QStringLiteral("ISO ")))
            continue;
        standard = word.section(u':', 0, 0);
        years << word.section(u':', 1);
    }
    years.sort();
    return standard + QStringLiteral(" · ") + years.join(QStringLiteral(", "));
}

/// Dashed frame that tells where to drop files; the whole window accepts them.
class DropField : public QLabel {
public:
    explicit DropField(QWidget *parent)
        : QLabel(parent) {
        setAlignment(Qt::AlignCenter);
        setFont(themeFont(TextSize::small));
        setProperty("secondary", true);
        setMinimumHeight(40);
        setContentsMargins(12, 0, 12, 0);
        setWordWrap(true);
    }

protected:
    void paintEvent(QPaintEvent *event) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(token(Token::lineStrong, palette()), 1, Qt::DashLine));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
        painter.end();
        QLabel::paintEvent(event);
    }
};

/// A card with a title row and a list below.
QFrame *makeCard(QWidget *parent, QLabel *title, QLabel *note, const QList<QWidget *> &content) {
    auto *card = new QFrame(parent);
    card->setProperty("card", true);
    auto *column = inColumn(card, {1, 1, 1, 4}, 0, {});
    title->setFont(themeFont(TextSize::head));
    auto *head = inRow(nullptr, {12, 8, 12, 8}, styleSpacing, {title, Placed::stretch()});
    if (note) {
        note->setFont(themeFont(TextSize::small));
        note->setProperty("secondary", true);
        head->addWidget(note);
    }
    column->addLayout(head);
    for (QWidget *widget : content)
        column->addWidget(widget);
    return card;
}

} // namespace

WelcomePage::WelcomePage(QWidget *parent)
    : Translated(parent)
    , m_place(new QScrollArea(this))
    , m_page(new QWidget(m_place->viewport()))
    , m_body(new QWidget(m_page))
    , m_subtitle(made<QLabel>(trait::secondary, m_body))
    , m_dropHint(new DropField(m_body))
    , m_recentTitle(new QLabel(m_body))
    , m_noRecent(made<QLabel>(trait::secondary, trait::wrapped, m_body))
    , m_examplesTitle(new QLabel(m_body))
    , m_examplesNote(new QLabel(m_body))
    , m_teachingTitle(new QLabel(m_body))
    , m_new(made<StartButton>("welcomeNew", QStringLiteral("axis"), m_body, StartButton::Picture::deviation))
    , m_newCircle(made<StartButton>("welcomeNewCircle", QStringLiteral("circle"), m_body,
                                    StartButton::Picture::circle))
    , m_open(made<StartButton>("welcomeOpen", QStringLiteral("open"), m_body))
    , m_import(made<StartButton>("welcomeImport", QStringLiteral("imp"), m_body))
    , m_plan(made<StartButton>("welcomePlan", QStringLiteral("plan"), m_body))
    , m_recentList(made<StartList>("recentList", m_recent, mostRecent, m_body))
    , m_examplesList(made<StartList>("examplesList", m_examples, m_body))
    , m_teachingList(made<StartList>("teachingList", m_teaching, m_body)) {
    setObjectName(QStringLiteral("welcome"));

    auto *logo = new QLabel(m_body);
    logo->setPixmap(QIcon(QStringLiteral(":/icons/palmer.svg")).pixmap(QSize(40, 40)));
    auto *name = new QLabel(QStringLiteral("Palmer"), m_body);
    QFont nameFont = themeFont(TextSize::head);
    nameFont.setPointSizeF(nameFont.pointSizeF() * 1.8);
    name->setFont(nameFont);
    auto *names = inColumn(0, {name, m_subtitle});

    auto *head = inRow(
        16,
        {logo, {names, 1}, {new LanguageSwitch(LanguageSwitch::Names::full, m_body), 0, Qt::AlignVCenter}});

    auto *starts = new QGridLayout;
    starts->setSpacing(12);
    starts->addWidget(m_new, 0, 0);
    starts->addWidget(m_newCircle, 0, 1);
    starts->addWidget(m_open, 1, 0);
    starts->addWidget(m_import, 1, 1);
    starts->addWidget(m_plan, 2, 0);
    starts->addWidget(m_dropHint, 2, 1);
    starts->addWidget(makeCard(m_body, m_examplesTitle, m_examplesNote, {m_examplesList}), 3, 0, 1, 2);
    starts->addWidget(makeCard(m_body, m_teachingTitle, nullptr, {m_teachingList}), 4, 0, 1, 2);
    starts->setColumnStretch(0, 1);
    starts->setColumnStretch(1, 1);
    starts->setRowStretch(5, 1);

    m_noRecent->setContentsMargins(12, 0, 12, 8);
    auto *lists = inColumn(
        16, {makeCard(m_body, m_recentTitle, nullptr, {m_noRecent, m_recentList}), Placed::stretch()});

    m_body->setMaximumWidth(contentWidth);
    auto *grid = new QGridLayout(m_body);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(16);
    grid->setRowMinimumHeight(0, 48);
    grid->addLayout(head, 0, 0, 1, 2);
    grid->addLayout(starts, 1, 0);
    grid->addLayout(lists, 1, 1);
    grid->setColumnStretch(0, 9);
    grid->setColumnStretch(1, 5);
    grid->setRowStretch(1, 1);

    inRow(m_page, {32, 16, 32, 16}, styleSpacing, {Placed::stretch(1), {m_body, 1000}, Placed::stretch(1)});
    m_place->setWidget(m_page);
    m_place->setWidgetResizable(true);
    m_place->setFrameShape(QFrame::NoFrame);
    m_place->setFocusPolicy(Qt::NoFocus);
    inColumn(this, noMargins, styleSpacing, {m_place});

    setTabOrder(m_new, m_newCircle);
    setTabOrder(m_newCircle, m_open);
    setTabOrder(m_open, m_import);
    setTabOrder(m_import, m_plan);
    setTabOrder(m_plan, m_recentList);
    setTabOrder(m_recentList, m_examplesList);
    setTabOrder(m_examplesList, m_teachingList);
    connect(m_new, &QAbstractButton::clicked, this, &WelcomePage::newAsked);
    connect(m_newCircle, &QAbstractButton::clicked, this, &WelcomePage::newCircleAsked);
    connect(m_open, &QAbstractButton::clicked, this, &WelcomePage::openAsked);
    connect(m_import, &QAbstractButton::clicked, this, &WelcomePage::importAsked);
    connect(m_plan, &QAbstractButton::clicked, this, &WelcomePage::planAsked);
    connect(m_recentList, &StartList::chosen, this, &WelcomePage::fileChosen);
    connect(m_examplesList, &StartList::chosen, this, &WelcomePage::fileChosen);
    connect(m_teachingList, &StartList::chosen, this, &WelcomePage::fileChosen);
    retranslate();
}

void WelcomePage::refresh() {
    std::vector<StartEntry> recent;
    const std::vector<RecentFile> files = recentFiles();
    for (const RecentFile &file : files) {
        QStringList detail{file.machine, file.axes};
        detail.removeAll(QString());
        recent.push_back(
            {file.path, kindIcon(file.circular), shortName(file, files), detail.join(QStringLiteral(" · ")),
             file.date.isValid() ? QLocale().toString(file.date, QLocale::ShortFormat) : QString(),
             file.verdict ? limitsMark(file.verdict, true) : VerdictMark(),
             file.accordance ? accordanceMark(*file.accordance) : VerdictMark()});
    }
    m_noRecent->setVisible(recent.empty());
    m_recentList->setVisible(!recent.empty());
    m_recent.setEntries(std::move(recent));

    std::vector<StartEntry> carried;
    std::vector<StartEntry> teaching; // all of one kind and edition
    std::vector<Example> all = examples();
    all.push_back(typeExample());
    for (const Example &example : all)
        (example.teaching ? teaching : carried)
            .push_back({example.path,
                        kindIcon(example.circular),
                        example.name,
                        {},
                        example.teaching ? QString() : example.year,
                        {}});
    m_examples.setEntries(std::move(carried));
    m_teaching.setEntries(std::move(teaching));
}

void WelcomePage::showEvent(QShowEvent *event) {
    refresh();
    QWidget::showEvent(event);
}

void WelcomePage::retranslate() {
    setAccessibleName(tr("Welcome"));
    m_subtitle->setText(tr("Tests of machine tools: measure, judge, print the report"));
    m_new->setTexts(tr("&New positioning test…"), tr("type or paste the readings"),
                    QKeySequence(QKeySequence::New).toString(QKeySequence::NativeText));
    m_newCircle->setTexts(tr("New &circular test…"), tr("type or paste the points of the arcs"),
                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N).toString(QKeySequence::NativeText));
    m_new->setStandard(standardOf(Kind::positioning));
    m_newCircle->setStandard(standardOf(Kind::circular));
    m_open->setTexts(tr("&Open…"), tr("a test file, .palmer, or a report"),
                     QKeySequence(QKeySequence::Open).toString(QKeySequence::NativeText));
    m_import->setTexts(tr("&Import…"), tr("tables and files of instruments"),
                       QKeySequence(Qt::CTRL | Qt::Key_I).toString(QKeySequence::NativeText));
    m_plan->setTexts(tr("P&lan of targets…"), tr("targets, part program, table to fill in"),
                     QKeySequence(Qt::CTRL | Qt::Key_L).toString(QKeySequence::NativeText));
    m_dropHint->setText(
        tr("or drop files into the window — %1")
            .arg(QStringLiteral(".palmer, .pdf, .") + importEndings().join(QStringLiteral(", ."))));
    m_recentTitle->setText(tr("Recent files"));
    m_noRecent->setText(tr("No file yet. Begin with an example."));
    m_examplesTitle->setText(tr("Examples"));
    m_examplesNote->setText(tr("verified results"));
    m_recentList->setAccessibleName(tr("Recent files"));
    m_examplesList->setAccessibleName(tr("Examples"));
    m_teachingTitle->setText(tr("Diagnosis: one influence each"));
    m_teachingList->setAccessibleName(m_teachingTitle->text());
    if (isVisible())
        refresh();
}

} // namespace palmer::ui
