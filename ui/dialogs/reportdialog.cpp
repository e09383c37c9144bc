// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/reportdialog.h"

#include "document/savefiles.h"
#include "document/spool.h"
#include "document/testfile.h"
#include "export/dcc.h"
#include "export/resultsjson.h"
#include "print/pdf/writepdf.h"
#include "report/composereport.h"
#include "report/parts/parts.h"
#include "ui/dialogs/pagecolumn.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/figures/plotgestures.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/page.h"
#include "ui/saving.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"
#include "validation/validation.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QUrl>
#include <QtMath>
#include <algorithm>
#include <array>
#include <memory>

namespace palmer::ui {

namespace {

constexpr int sideWidth = 340; ///< fits the longest choice and a scroll bar
constexpr int smallWidth = 132;
constexpr double smallestScale = 0.25;
constexpr double largestScale = 6;
constexpr double screenPointsPerInch = 96.0 / 72.0; ///< pixels per point at 100 %

enum LanguageButton { frenchOnly, englishOnly, bothLanguages };

Language::Id idOf(ReportLanguage language) {
    return language == ReportLanguage::fr ? Language::Id::french : Language::Id::english;
}

template <typename Word>
bool holds(const std::vector<Word> &list, Word word) {
    return std::ranges::find(list, word) != list.end();
}

/// Adds a value to a list or removes it, keeping the order of the others.
template <typename Word>
void put(std::vector<Word> &list, Word word, bool in) {
    if (in && !holds(list, word))
        list.push_back(word);
    else if (!in)
        std::erase(list, word);
}

} // namespace

ReportDialog::ReportDialog(DocumentModel &model, Evaluator &evaluator, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_evaluator(evaluator)
    , m_simulator(evaluator)
    , m_small(new PageColumn(this))
    , m_column(new PageColumn(this))
    , m_smallArea(made<QScrollArea>("smallPages", this))
    , m_area(made<QScrollArea>("pages", this)) {
    setObjectName(QStringLiteral("reportDialog"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    resize(sizeOnScreen(*this, {1280, 800}));
    m_small->setNumbered(true);
    m_small->setScale(96 / 595.0);
    m_smallArea->setWidget(m_small);
    m_area->setWidget(m_column);
    for (QScrollArea *area : {m_smallArea, m_area}) {
        area->setFrameShape(QFrame::NoFrame);
        area->setAlignment(Qt::AlignHCenter);
    }
    m_smallArea->setFixedWidth(smallWidth);
    m_smallArea->setFocusPolicy(Qt::NoFocus);
    m_smallArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setBackgroundRole(QPalette::Mid);

    auto *head = makeHead();
    auto *body = inRow(0, {m_smallArea, {m_area, 1}, makeSide()});
    inColumn(this, noMargins, 0, {head, {body, 1}});

    connect(m_small, &PageColumn::clicked, this, &ReportDialog::goTo);
    connect(m_area->verticalScrollBar(), &QScrollBar::valueChanged, this, &ReportDialog::followScroll);
    connect(&m_evaluator, &Evaluator::evaluated, this, &ReportDialog::showDocument);
    connect(&m_simulator, &Simulator::progressed, this, &ReportDialog::showProgress);
    connect(&m_simulator, &Simulator::finished, this, &ReportDialog::showProgress);
    retranslate();
}

QWidget *ReportDialog::makeHead() {
    auto *head = new QWidget(this);
    head->setFixedHeight(pageBarHeight);
    m_title = made<QLabel>(TextSize::title, head);
    m_summary = made<ElidedLabel>(TextSize::small, trait::secondary, head);
    m_open = made<QPushButton>(trait::link, trait::notDefault, head);
    m_openFolder = made<QPushButton>(trait::link, trait::notDefault, head);
    m_open->setObjectName(QStringLiteral("openSaved"));
    m_openFolder->setObjectName(QStringLiteral("openFolder"));
    for (QPushButton *link : {m_open, m_openFolder})
        link->hide();
    connect(m_open, &QPushButton::clicked, this, [this] {
        for (const QString &file : m_saved)
            QDesktopServices::openUrl(QUrl::fromLocalFile(file));
    });
    connect(m_openFolder, &QPushButton::clicked, this, [this] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(m_saved.constFirst()).absolutePath()));
    });
    m_previous = iconButton(head, QStringLiteral("previousPage"), QStringLiteral("left"));
    m_next = iconButton(head, QStringLiteral("nextPage"), QStringLiteral("right"));
    m_smaller = iconButton(head, QStringLiteral("smaller"), QStringLiteral("zoomout"));
    m_larger = iconButton(head, QStringLiteral("larger"), QStringLiteral("zoomin"));
    m_previous->setShortcut(QKeySequence(Qt::Key_PageUp));
    m_next->setShortcut(QKeySequence(Qt::Key_PageDown));
    m_smaller->setShortcut(QKeySequence::ZoomOut);
    m_larger->setShortcut(QKeySequence::ZoomIn);
    m_place = new QLabel(head);
    m_zoom = new QLabel(head);
    m_width = made<QPushButton>("fitWidth", trait::notDefault, head);
    inRow(head, {pageMargin, 0, pageMargin, 0}, styleSpacing,
          {m_title,
           {m_summary, 1},
           m_open,
           m_openFolder,
           m_previous,
           m_place,
           m_next,
           m_smaller,
           m_zoom,
           m_larger,
           m_width});
    connect(m_previous, &QToolButton::clicked, this,
            [this] { goTo(m_column->pageAt(m_area->verticalScrollBar()->value()) - 1); });
    connect(m_next, &QToolButton::clicked, this,
            [this] { goTo(m_column->pageAt(m_area->verticalScrollBar()->value()) + 1); });
    const auto zoom = [this](double factor) {
        m_fit = false;
        setScale(m_column->scale() * factor);
    };
    connect(m_smaller, &QToolButton::clicked, this, [zoom] { zoom(1 / zoomStep); });
    connect(m_larger, &QToolButton::clicked, this, [zoom] { zoom(zoomStep); });
    connect(m_width, &QPushButton::clicked, this, &ReportDialog::fitWidth);
    return head;
}

QWidget *ReportDialog::makeSide() {
    auto *side = new QWidget(this);
    side->setFixedWidth(sideWidth);
    auto *whole = inColumn(side, {pageMargin, 12, pageMargin, 12}, 8, {});
    auto *place = new QScrollArea(side); // on low screens the choices are higher than the dialog
    trait::scrollsDown(*place);
    auto *choices = new QWidget(place);
    auto *column = inColumn(choices, noMargins, 8, {});
    const auto title = [&] {
        auto *label = made<QLabel>(TextSize::small, trait::secondary, side);
        column->addWidget(label);
        return label;
    };

    m_languageTitle = title();
    makeLanguages(*column);

    m_paperTitle = title();
    m_paper = made<QComboBox>("paper", trait::strongFocus, side);
    m_paper->addItem(QStringLiteral("A4"));
    m_paper->addItem(QStringLiteral("Letter"));
    m_paperTitle->setBuddy(m_paper);
    column->addWidget(m_paper);
    connect(m_paper, &QComboBox::activated, this, [this](int index) {
        change([index](ReportHead &head) { head.paper = index == 0 ? Paper::a4 : Paper::letter; });
    });

    m_sectionsTitle = title();
    addChoices(column);

    column->addStretch();
    place->setWidget(choices);
    whole->addWidget(place, 1);
    makeSimulation(*whole);
    makeNotes(*whole);
    makeButtons(*whole);
    return side;
}

void ReportDialog::makeLanguages(QVBoxLayout &column) {
    m_languages = new QButtonGroup(this);
    auto *segments = inRow(0, {});
    const std::array names{QStringLiteral("Français"), QStringLiteral("English"), QString()};
    const std::array objects{QStringLiteral("reportFrench"), QStringLiteral("reportEnglish"),
                             QStringLiteral("reportBoth")};
    constexpr std::array places{"first", "middle", "last"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto *button = made<QToolButton>(objects[i], trait::checkable, trait::strongFocus,
                                         trait::segment(places.at(i)), this);
        button->setText(names[i]);
        button->setAccessibleName(names[i]);
        m_languages->addButton(button, static_cast<int>(i));
        segments->addWidget(button);
        m_both = button;
    }
    segments->addStretch();
    column.addLayout(segments);
    connect(m_languages, &QButtonGroup::idClicked, this, [this](int id) {
        change([id](ReportHead &head) {
            if (id == bothLanguages)
                head.languages = {ReportLanguage::fr, ReportLanguage::en};
            else
                head.languages = {id == frenchOnly ? ReportLanguage::fr : ReportLanguage::en};
        });
    });
}

/// Shown while a simulation runs.
void ReportDialog::makeSimulation(QVBoxLayout &whole) {
    m_simulation = new QWidget(this);
    m_simulationText = made<QLabel>("simulationText", trait::wrapped, m_simulation);
    m_simulationBar = new QProgressBar(m_simulation);
    m_simulationBar->setTextVisible(false);
    m_simulationCancel = made<QPushButton>("cancelSimulation", trait::notDefault, m_simulation);
    inColumn(m_simulation, noMargins, styleSpacing, {m_simulationText, m_simulationBar, m_simulationCancel});
    m_simulation->hide();
    connect(m_simulationCancel, &QPushButton::clicked, this, [this] { m_simulator.cancel(); });
    whole.addWidget(m_simulation);
}

/// Notes on what the file will contain and what is missing.
void ReportDialog::makeNotes(QVBoxLayout &whole) {
    m_originals = made<QCheckBox>("withOriginals", this);
    connect(m_originals, &QCheckBox::clicked, this, &ReportDialog::showDocument);
    whole.addWidget(m_originals);
    m_certificate = made<QCheckBox>("withDcc", this);
    whole.addWidget(m_certificate);
    m_attached = made<QLabel>("attachedNote", TextSize::small, trait::secondary, trait::wrapped, this);
    whole.addWidget(m_attached);
    m_missing = made<QLabel>("missingNote", trait::wrapped, this);
    whole.addWidget(m_missing);
}

void ReportDialog::makeButtons(QVBoxLayout &whole) {
    m_save = made<QPushButton>("savePdf", trait::primary, this);
    m_save->setIcon(lineIcon(QStringLiteral("pdf"), QPalette::Base));
    m_save->setDefault(true);
    whole.addWidget(m_save);
    m_print = made<QPushButton>("print", trait::notDefault, this);
    m_print->setIcon(lineIcon(QStringLiteral("print")));
    m_close = made<QPushButton>("closeReport", trait::notDefault, this);
    whole.addLayout(inRow(styleSpacing, {m_print, m_close}));
    connect(m_save, &QPushButton::clicked, this, &ReportDialog::choosePdf);
    connect(m_print, &QPushButton::clicked, this, &ReportDialog::choosePrinter);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void ReportDialog::addChoices(QVBoxLayout *column) {
    const auto add = [&](const char *name, const char *text, auto isOn, auto set) {
        auto *box = made<QCheckBox>(name, this);
        column->addWidget(box);
        const std::size_t index = m_choices.size();
        m_choices.push_back({box, text, isOn, set});
        connect(box, &QCheckBox::clicked, this, [this, index](bool on) {
            change([&](ReportHead &head) { m_choices[index].set(head, on); });
        });
    };
    const auto part = [&](const char *name, const char *text, ReportPart which) {
        add(
            name, text, [which](const ReportHead &head) { return !holds(head.leaveOut, which); },
            [which](ReportHead &head, bool on) { put(head.leaveOut, which, !on); });
    };
    const auto extra = [&](const char *name, const char *text, ReportExtra which) {
        add(
            name, text, [which](const ReportHead &head) { return holds(head.include, which); },
            [which](ReportHead &head, bool on) { put(head.include, which, on); });
    };
    const auto signer = [&](const char *name, const char *text, Signer which) {
        add(
            name, text, [which](const ReportHead &head) { return holds(head.signatures, which); },
            [which](ReportHead &head, bool on) { put(head.signatures, which, on); });
    };
    part("partAnnex", QT_TR_NOOP("Annex"), ReportPart::annex);
    part("partTargetTable", QT_TR_NOOP("Values per target"), ReportPart::targetTable);
    part("partReadings", QT_TR_NOOP("Readings"), ReportPart::readings);
    part("partTemperatureCurve", QT_TR_NOOP("Temperature curve"), ReportPart::temperatureCurve);
    part("partFindings", QT_TR_NOOP("Findings"), ReportPart::findings);
    part("partSignatures", QT_TR_NOOP("Signatures"), ReportPart::signatures);
    extra("extraReadingMarks", QT_TR_NOOP("Single readings in the figure"), ReportExtra::readingMarks);
    extra("extraAllReadings", QT_TR_NOOP("All readings (over 2000 rows)"), ReportExtra::allReadings);
    m_allReadings = m_choices.back().box;
    add(
        "roundTwoDigits", QT_TR_NOOP("U to two significant digits"),
        [](const ReportHead &head) { return head.rounding == Rounding::twoDigits; },
        [](ReportHead &head, bool on) { head.rounding = on ? Rounding::twoDigits : Rounding::palmer; });
    extra("extraDiagnosis", QT_TR_NOOP("Diagnosis of circles"), ReportExtra::diagnosis);
    extra("extraMeanRepeatability", QT_TR_NOOP("Mean repeatability (1988)"), ReportExtra::meanRepeatability);
    m_signaturesTitle = made<QLabel>(TextSize::small, trait::secondary, this);
    column->addWidget(m_signaturesTitle);
    signer("signOperator", QT_TR_NOOP("Operator"), Signer::operatorSigns);
    signer("signLaboratory", QT_TR_NOOP("Laboratory"), Signer::laboratory);
    signer("signSupplier", QT_TR_NOOP("Supplier"), Signer::supplier);
    signer("signCustomer", QT_TR_NOOP("Customer"), Signer::customer);
}

void ReportDialog::change(const std::function<void(ReportHead &)> &change) {
    m_model.edit(
        QT_TRANSLATE_NOOP("edits", "choose what the report has"),
        [&](Document &document) { change(document.report); }, QStringLiteral("report.form"));
    showDocument(); // updates the buttons even if nothing changed
}

/// Composes the pages of the latest document, unless they are there. Other results of the same document wait
/// until the pages being composed are shown: simulations that end one after another would let none be seen.
void ReportDialog::compose() {
    const EvaluatedDocument &current = m_evaluator.current();
    const Source source{m_model.document(), current.tests,
                        holdsOriginals(*m_model.document()) && m_originals->isChecked()
                            ? Originals::include
                            : Originals::leaveOut};
    if (source == m_source)
        return;
    const bool onlyResults = source.document == m_source.document && source.originals == m_source.originals;
    if (m_composer.isBusy() && onlyResults)
        return;
    m_composer.cancel();
    m_source = source;
    m_composer.start(
        [this, source, onlyResults, previous = current](const Background::Job &job) {
            return composed(job, source, previous, !onlyResults);
        },
        [this](std::shared_ptr<const Composed> composed) { take(std::move(composed)); });
}

/// Prints the file's own editions: views under another edition belong to the window. `showsFirst`: shows the
/// first page meanwhile; otherwise the pages in view stay, so that other results do not turn back to it.
std::shared_ptr<const ReportDialog::Composed> ReportDialog::composed(const Background::Job &job,
                                                                     Source source,
                                                                     const EvaluatedDocument &previous,
                                                                     bool showsFirst) {
    auto result = std::make_shared<Composed>();
    try {
        result->evaluated = evaluate(source.document, &previous);
        job.post([this, evaluated = result->evaluated] { showEvaluated(evaluated); });
        source.results = result->evaluated.tests;
        const auto same = [&source](const auto &kept) {
            return *kept->source.document == *source.document && kept->source.results == source.results &&
                   kept->source.originals == source.originals;
        };
        if (const auto found = std::ranges::find_if(m_kept, same); found != m_kept.end())
            return *found;
        result->source = source;
        ReportOptions options{
            QStringLiteral("Palmer " PALMER_VERSION), selfTestPasses(), source.originals, {}, job.stop()};
        if (showsFirst)
            options.onFirstPage = [this, &job](const Report &report) {
                job.post([this, pages = firstPages(report)] { showPages(pages); });
            };
        for (const ReportLanguage language : source.document->report.languages) {
            result->reports.push_back(composeReport(result->evaluated, Language(idOf(language)), options));
            const Report &report = result->reports.back();
            options.testFile = report.testFile; // the same in each language
            options.onFirstPage = {};
            std::ranges::move(layoutPages(report, job.stop()), std::back_inserter(result->pages));
        }
        if (!job.stop().stop_requested())
            keep(result);
    } catch (const Error &error) {
        result->reports.clear();
        result->pages.clear();
        result->refused = error.message;
    }
    return result;
}

/// Keeps what was composed last, and of what came before as much as a thousand pages.
void ReportDialog::keep(const std::shared_ptr<const Composed> &composed) {
    constexpr std::size_t most = 8;
    constexpr std::size_t mostPages = 1000;
    m_kept.push_back(composed);
    std::size_t pages = 0;
    std::size_t first = m_kept.size() - 1;
    while (first > 0 && m_kept.size() - first < most &&
           (pages += m_kept[first - 1]->pages.size()) <= mostPages)
        --first;
    m_kept.erase(m_kept.begin(), m_kept.begin() + static_cast<std::ptrdiff_t>(first));
}

void ReportDialog::take(std::shared_ptr<const Composed> composed) {
    m_composed = std::move(composed);
    m_evaluated = m_composed->evaluated;
    showPages(m_composed->pages);
    goToAnchor();
    showDocument(); // and composes again if other results have come
    if (m_composed->refused)
        m_summary->setText(windowLanguage().sentence(*m_composed->refused));
}

/// The budget is printed with a simulation, which runs while the pages can be viewed.
void ReportDialog::showEvaluated(EvaluatedDocument evaluated) {
    m_evaluated = std::move(evaluated);
    if (m_simulated != m_evaluated.document && !m_simulator.isRunning()) {
        m_simulated = m_evaluated.document;
        m_simulator.startMissing(m_evaluated);
    }
    const int missing = countMissing(m_evaluated);
    QStringList notes(m_note);
    if (missing > 0)
        notes << withGroups(tr("%n required statement(s) missing; printed as “–”", nullptr, missing),
                            missing);
    notes.removeAll(QString());
    m_missing->setVisible(!notes.isEmpty());
    m_missing->setText(notes.join(u'\n'));
}

void ReportDialog::showPages(Pages pages) {
    m_pages = std::move(pages);
    m_small->setPages(m_pages);
    m_column->setPages(m_pages);
    if (m_fit)
        fitWidth();
    followScroll();
}

void ReportDialog::showDocument() {
    compose();
    const ReportHead &head = m_model.document()->report;
    const bool french = holds(head.languages, ReportLanguage::fr);
    const bool english = holds(head.languages, ReportLanguage::en);
    m_languages->button(french && english ? bothLanguages
                        : french          ? frenchOnly
                                          : englishOnly)
        ->setChecked(true);
    m_paper->setCurrentIndex(head.paper == Paper::a4 ? 0 : 1);
    for (const Choice &choice : m_choices)
        choice.box->setChecked(choice.isOn(head));
    showLength();
    m_originals->setVisible(holdsOriginals(*m_model.document()));
    m_attached->setVisible(!m_composed->reports.empty());
    if (!m_composed->reports.empty()) {
        const Report &report = m_composed->reports.front();
        m_attached->setText(
            tr("In the PDF: the whole test file (%1, %2), remarks and names in it included, and the results")
                .arg(report.testFileName, QLocale().formattedDataSize(report.testFile.size())));
    }
    const QString number = QString::fromStdString(head.number);
    m_title->setText(number.isEmpty() ? tr("Report") : tr("Report %1").arg(number));
    showSaved({});
    if (isComposing())
        m_summary->setText(tr("Composing the pages…"));
    else if (!m_composed->reports.empty())
        m_summary->setText(
            tr("%n page(s) %1 · preview = PDF = paper", nullptr, pageCount()).arg(m_paper->currentText()));
    followScroll();
    showProgress();
}

/// Shows how many pages all readings would add, before that is chosen.
void ReportDialog::showLength() {
    const int pages = pagesOfAllReadings(*m_model.document());
    m_allReadings->setText(pages > 0 ? tr("All readings (about %n more page(s))", nullptr, pages)
                                     : tr("All readings (over 2000 rows)"));
}

void ReportDialog::showProgress() {
    m_simulation->setVisible(m_simulator.isRunning());
    const bool ready = !isSimulating() && !m_writer.isBusy() && !m_pages.empty();
    m_save->setEnabled(ready);
    m_print->setEnabled(ready);
    m_close->setEnabled(!m_writer.isBusy());
    const SimulationProgress &progress = m_simulator.progress();
    QString text =
        tr("Monte Carlo: %1 trials")
            .arg(windowLanguage().number(static_cast<double>(progress.trials), Quantity::count, 0));
    if (const auto left = m_simulator.secondsLeft())
        text += QStringLiteral(" · ") + tr("%1 s left").arg(qCeil(*left));
    m_simulationText->setText(text);
    m_simulationBar->setRange(0, progress.of ? 100 : 0);
    if (progress.of)
        m_simulationBar->setValue(static_cast<int>(100 * progress.trials / *progress.of));
}

int ReportDialog::pageCount() const {
    return static_cast<int>(m_pages.size());
}

void ReportDialog::goTo(int page) {
    const int inside = std::clamp(page, 0, std::max(0, pageCount() - 1));
    if (pageCount() > 0)
        m_area->verticalScrollBar()->setValue(m_column->pageRect(inside).top() - 8);
}

void ReportDialog::goToAnchor() {
    const QString anchor = std::exchange(m_anchor, QString());
    for (std::size_t page = 0; page < m_pages.size() && !anchor.isEmpty(); ++page) {
        const auto &marks = m_pages[page].bookmarks;
        const auto found = std::ranges::find(marks, anchor, &Bookmark::anchor);
        if (found == marks.end())
            continue;
        const double top = m_column->pageRect(static_cast<int>(page)).top() + found->y * m_column->scale();
        return m_area->verticalScrollBar()->setValue(static_cast<int>(top) - 8);
    }
}

void ReportDialog::followScroll() {
    const int page = m_column->pageAt(m_area->verticalScrollBar()->value() + 9);
    m_small->setCurrent(page);
    if (pageCount() > 0)
        m_smallArea->ensureVisible(0, m_small->pageRect(page).center().y(), 0, 100);
    m_place->setText(QStringLiteral("%1 / %2").arg(page + 1).arg(
        isComposing() ? QStringLiteral("–") : QString::number(pageCount())));
    m_previous->setEnabled(page > 0);
    m_next->setEnabled(page + 1 < pageCount());
}

void ReportDialog::setScale(double scale) {
    const int page = m_column->pageAt(m_area->verticalScrollBar()->value() + 9);
    m_column->setScale(std::clamp(scale, smallestScale, largestScale));
    m_zoom->setText(tr("%1 %").arg(qRound(m_column->scale() / screenPointsPerInch * 100)));
    goTo(page);
    followScroll();
}

void ReportDialog::fitWidth() {
    m_fit = true;
    if (m_pages.empty())
        return;
    const int room = m_area->viewport()->width() - 48;
    setScale(room / m_pages.front().size.width());
}

void ReportDialog::choosePdf() {
    SaveDialog dialog(this, tr("Save the report"), {tr("PDF files (*.pdf)")});
    dialog.setObjectName(QStringLiteral("pdfDialog"));
    // With two languages other file names are written, which are checked here.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    const QFileInfo file(m_model.path());
    if (!m_model.path().isEmpty()) {
        dialog.setDirectory(file.absolutePath());
        dialog.selectFile(file.completeBaseName() + QStringLiteral(".pdf"));
    }
    while (dialog.exec() == QDialog::Accepted) {
        const QString path = dialog.selectedFiles().constFirst();
        if (mayReplace(filesOf(path))) {
            saveTo(path);
            return;
        }
    }
}

QStringList ReportDialog::filesOf(const QString &path) const {
    if (m_composed->reports.size() == 1)
        return {path};
    const QFileInfo name(path);
    QStringList files;
    for (const Report &report : m_composed->reports)
        files +=
            name.dir().filePath(QStringLiteral("%1.%2.pdf").arg(name.completeBaseName(), report.language));
    return files;
}

bool ReportDialog::mayReplace(const QStringList &files) {
    QStringList there;
    for (const QString &file : files) {
        if (QFileInfo(file).isFile())
            there += QFileInfo(file).fileName();
    }
    if (there.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Warning, windowTitle(),
                    tr("Replace %1?").arg(there.join(QStringLiteral(", "))), QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("replaceBox"));
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(tr("What is there now is lost."));
    auto *replace = box.addButton(tr("&Replace"), QMessageBox::AcceptRole);
    replace->setObjectName(QStringLiteral("replace"));
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
}

void ReportDialog::saveTo(const QString &path) {
    const bool certified = m_certificate->isChecked();
    m_summary->setText(tr("Saving…"));
    showSaved({});
    m_writer.start(
        [files = filesOf(path), composed = m_composed, evaluated = m_evaluated, certified,
         language = windowLanguage()](const Background::Job &) -> Written {
            std::vector<FileToSave> written;
            QString file = files.constFirst(); // being written
            try {
                if (certified)
                    requireForDcc(evaluated, language);
                const std::vector<PdfAttachment> attachments =
                    attachmentsOf(composed->reports.front().testFileName, composed->reports.front().testFile,
                                  attachedResults(evaluated), certified ? dcc(evaluated) : QByteArray());
                for (std::size_t i = 0; i < composed->reports.size(); ++i) {
                    file = files[static_cast<qsizetype>(i)];
                    requireNoTestFileName(file);
                    const auto pdf = std::make_shared<Spool>();
                    writePdf(composed->reports[i], *pdf, attachments);
                    written.push_back({pdf->bytes(), file, pdf});
                }
                saveFiles(written);
            } catch (const UnsavedFile &error) {
                return {files, error.path, error.message};
            } catch (const Error &error) {
                return {files, file, error.message};
            }
            return {files};
        },
        [this](const Written &written) { take(written); });
    showProgress();
}

void ReportDialog::take(const Written &written) {
    const bool done = written.refused.isEmpty();
    showDocument();
    if (done) {
        m_summary->setText(tr("Saved: %1").arg(written.files.join(QStringLiteral(", "))));
        showSaved(written.files);
    } else {
        showError(this, tr("%1 cannot be saved").arg(QFileInfo(written.refused).fileName()),
                  windowLanguage().sentence(written.why));
    }
    emit saved(done ? written.files : QStringList());
}

/// A file that is being written is written whole.
void ReportDialog::reject() {
    if (!m_writer.isBusy())
        QDialog::reject();
}

/// Shows buttons to open what was last saved; none once the pages have changed.
void ReportDialog::showSaved(const QStringList &files) {
    m_saved = files;
    m_open->setVisible(!files.isEmpty());
    m_openFolder->setVisible(!files.isEmpty());
}

void ReportDialog::choosePrinter() {
    QPrinter printer(QPrinter::HighResolution);
    printer.setDocName(m_title->text());
    printer.setFullPage(true);
    if (!m_pages.empty())
        printer.setPageSize(
            QPageSize(m_pages.front().size, QPageSize::Point, QString(), QPageSize::FuzzyMatch));
    QPrintDialog dialog(&printer, this);
    dialog.setMinMax(1, pageCount());
    dialog.setOption(QAbstractPrintDialog::PrintPageRange);
    if (dialog.exec() == QDialog::Accepted && !printOn(printer)) {
        auto *box = new QMessageBox(QMessageBox::Critical, windowTitle(),
                                    tr("The printer did not accept the report."), QMessageBox::Ok, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    }
}

bool ReportDialog::printOn(QPrinter &printer) {
    printer.setFullPage(true);
    QPainter painter;
    if (m_pages.empty() || !painter.begin(&printer))
        return false;
    int first = 1;
    int last = pageCount();
    if (printer.printRange() == QPrinter::PageRange && printer.fromPage() > 0) {
        first = printer.fromPage();
        last = std::min(last, printer.toPage());
    }
    const double scale = printer.resolution() / 72.0;
    for (int page = first; page <= last; ++page) {
        if (page > first && !printer.newPage())
            return false;
        painter.save();
        painter.scale(scale, scale);
        drawPage(painter, m_pages[static_cast<std::size_t>(page - 1)]);
        painter.restore();
    }
    return painter.end();
}

void ReportDialog::resizeEvent(QResizeEvent *event) {
    QDialog::resizeEvent(event);
    if (m_fit)
        fitWidth();
}

void ReportDialog::showEvent(QShowEvent *event) {
    QDialog::showEvent(event);
    if (m_fit)
        fitWidth();
}

void ReportDialog::retranslate() {
    setWindowTitle(tr("Report"));
    const auto name = [](QToolButton &button, const QString &text) {
        nameWidget(button, text, button.shortcut().toString(QKeySequence::NativeText));
    };
    name(*m_previous, tr("Previous page"));
    name(*m_next, tr("Next page"));
    name(*m_smaller, tr("Smaller"));
    name(*m_larger, tr("Larger"));
    m_width->setText(tr("&Width"));
    m_open->setText(tr("&Open"));
    m_openFolder->setText(tr("Open the &folder"));
    m_area->setAccessibleName(tr("Pages of the report"));
    m_smallArea->setAccessibleName(tr("Pages in small"));
    m_languageTitle->setText(tr("Language"));
    m_both->setText(tr("Both"));
    m_both->setAccessibleName(tr("Both languages"));
    m_paperTitle->setText(tr("P&aper"));
    m_paper->setAccessibleName(tr("Paper"));
    m_sectionsTitle->setText(tr("Sections"));
    m_signaturesTitle->setText(tr("Signatures"));
    for (const Choice &choice : m_choices)
        choice.box->setText(tr(choice.text));
    showLength();
    m_originals->setText(tr("Attach the instrument files, too"));
    m_certificate->setText(tr("Attach a digital calibration certificate (DCC)"));
    m_simulationCancel->setText(tr("Cancel"));
    m_save->setText(tr("&Save PDF…"));
    m_print->setText(tr("&Print…"));
    m_close->setText(tr("&Close"));
    showDocument();
}

} // namespace palmer::ui
