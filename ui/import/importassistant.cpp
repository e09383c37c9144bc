// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/importassistant.h"

#include "document/filewords.h"
#include "document/savedocument.h"
#include "document/sha256.h"
#include "document/windowthread.h"
#include "figures/testfigures.h"
#include "figures/thinning.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/figures/circlecanvas.h"
#include "ui/figures/figurecanvas.h"
#include "ui/figures/figurecard.h"
#include "ui/figures/zoombuttons.h"
#include "ui/import/columnroles.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/remarklist.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"
#include "ui/workbar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QTableView>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int mostBoxColumns = 6;
constexpr int boxSpacing = 12;
constexpr int boxContents = 12;     ///< minimum width of a choice, in letters
constexpr int linesAtOnce = 50'000; ///< text lines laid out per batch
constexpr int columnWidth = 72;     ///< of the recognised table, px, unless its heading is wider
constexpr int remarksHeight = 150;
constexpr int lowRemarksHeight = 72;
constexpr int lowBelow = 700; ///< height of the dialog, px

/// A part with its title, its size text or buttons on the right, and its content.
QWidget *part(QWidget *parent, QLabel *title, QWidget *beside, QWidget *content) {
    auto *whole = new QWidget(parent);
    whole->setProperty("ground", QStringLiteral("base"));
    title->setFont(themeFont(TextSize::head));
    auto *head = inRow(styleSpacing, {{title, 1}});
    if (beside) {
        head->addWidget(beside);
        head->addSpacing(8);
    }
    inColumn(whole, {12, 8, 4, 4}, styleSpacing, {head, {content, 1}});
    return whole;
}

/// The curve thinned to the screen's resolution; null for circles.
std::optional<CurveFigure> curveOf(const EvaluatedDocument &evaluated, const Language &language) {
    const Test &test = *evaluated.document->tests[0];
    if (isCircle(test))
        return std::nullopt;
    const CurveFigure figure = [&] {
        if (!traitsOf(test).hasTargets)
            return std::get<CurveFigure>(figureOfTest(test, *evaluated.tests[0], language));
        DeviationFigureOptions options;
        options.dimensions = false; // results are not examined before the readings are correct
        return deviationFigure(test, *evaluated.tests[0], language, options);
    }();
    return isOrdinary(figure) ? figure : thinned(figure);
}

/// A number as formatted in remarks; other text as typed.
QString asRead(const QString &value) {
    bool isNumber = false;
    const double number = value.toDouble(&isNumber);
    return isNumber ? windowLanguage().number(number, Quantity::number) : value;
}

/// Reverses the formatting of asRead: no group spaces, ASCII minus.
std::string asTyped(const QString &text) {
    return text.trimmed().remove(u'\u202F').replace(u'\u2212', u'-').toStdString();
}

QString profileSetting(const QString &fileName) {
    return QStringLiteral("import/profiles/") + QFileInfo(fileName).suffix().toLower();
}

} // namespace

MeasurementFile readMeasurementFile(const QByteArray &bytes, const QString &fileName,
                                    const ImportOptions &options) {
    const QString name = QFileInfo(fileName).fileName();
    MeasurementFile file{bytes, name, showMeasurement(bytes, name, options), sha256(bytes), nullptr, {}};
    file.lines = linesOf(file.imported);
    if (file.imported.test)
        file.test = std::make_shared<const Test>(*file.imported.test);
    return file;
}

bool isLargeFile(qint64 bytes) {
    constexpr qint64 shortestReading = 2; // bytes: a digit and a separator
    return bytes > shortestReading * qint64(fewReadings);
}

ImportAssistant::ImportAssistant(const QByteArray &bytes, const QString &fileName, const Document *open,
                                 QWidget *parent)
    : ImportAssistant(readMeasurementFile(bytes, fileName), open, parent) {}

ImportAssistant::ImportAssistant(MeasurementFile file, const Document *open, QWidget *parent)
    : Translated(parent)
    , m_file(std::move(file))
    , m_title(made<QLabel>(TextSize::title, trait::plainText, this))
    , m_origin(made<QLabel>(trait::secondary, this))
    , m_other(made<QPushButton>("importOther", trait::notDefault, this))
    , m_paste(made<QPushButton>("importPaste", trait::notDefault, this))
    , m_choices(new QGridLayout)
    , m_destinationName(new QLabel(this))
    , m_destination(made<ElidedBox>("import.destination", this))
    , m_profileName(new QLabel(this))
    , m_profile(made<ElidedBox>("import.profile", this))
    , m_rawTitle(new QLabel(this))
    , m_rawSize(made<QLabel>(trait::secondary, this))
    , m_rawView(made<QListView>("importRaw", this))
    , m_tableTitle(new QLabel(this))
    , m_tableSize(made<QLabel>(trait::secondary, this))
    , m_columns(new ColumnRoles(this))
    , m_table(made<QTableView>("importTable", this))
    , m_curveTitle(new QLabel(this))
    , m_zoom(new ZoomButtons(this))
    , m_curves(new QStackedWidget(this))
    , m_curveCanvas(made<FigureCanvas>("importCurve", m_selection, m_curves))
    , m_circleCanvas(made<CircleCanvas>("importCircle", m_selection, m_curves))
    , m_lineView(new LineView(m_curves))
    , m_noCurve(made<QLabel>(trait::secondary, trait::wrapped, m_curves))
    , m_remarksTitle(made<QLabel>(TextSize::head, this))
    , m_confirmAll(made<QPushButton>("confirmAll", trait::notDefault, this))
    , m_remarks(new RemarkList(this))
    , m_keep(made<QCheckBox>("keepBytes", this))
    , m_saveProfile(made<QPushButton>("saveProfile", trait::notDefault, this))
    , m_open(made<QLabel>("importOpen", this))
    , m_cancel(made<QPushButton>("cancelImport", trait::notDefault, this))
    , m_import(made<QPushButton>("acceptImport", trait::primary, trait::notDefault, this))
    , m_work(new WorkBar(this)) {
    if (open)
        m_document = *open;
    setObjectName(QStringLiteral("importAssistant"));
    resize(sizeOnScreen(*this, {1280, 800}));
    try {
        m_profiles = readImportProfiles(importProfilesPath());
    } catch (const Error &) {
        m_profiles.clear(); // a damaged profile file does not prevent an import; saving reports the error
    }
    makeLayout();
    m_rawView->setFocus();
    m_keep->setChecked(QSettings().value(QStringLiteral("import/keepBytes")).toBool());
    retranslate();
    useLastProfile();
}

void ImportAssistant::makeLayout() {
    auto *head = inRow(styleSpacing, {m_title, m_origin, m_work, Placed::stretch(), m_other, m_paste});
    m_choices->setHorizontalSpacing(boxSpacing);
    m_choices->setVerticalSpacing(6);
    for (const auto &[name, words] :
         {std::pair(m_destinationName, m_destination), std::pair(m_profileName, m_profile)}) {
        auto *cell = new QWidget(this);
        cell->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        inColumn(cell, noMargins, 2, {name, words});
        words->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        words->setMinimumContentsLength(boxContents);
    }

    auto *foot = inRow(styleSpacing, {m_keep, Placed::gap(24), m_saveProfile, Placed::stretch(), m_open,
                                      m_cancel, m_import});

    inColumn(this, styleMargins, styleSpacing, {head, m_choices, {makeMiddle(), 1}, makeRemarks(), foot});
    connectAll();
}

QWidget *ImportAssistant::makeMiddle() {
    m_rawView->setModel(&m_raw);
    m_rawView->setItemDelegate(new RawTextDelegate(m_rawView));
    m_rawView->setUniformItemSizes(true);
    m_rawView->setLayoutMode(QListView::Batched); // 10⁶ lines take a noticeable time
    m_rawView->setBatchSize(linesAtOnce);
    m_rawView->setFrameShape(QFrame::NoFrame);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(font().pointSizeF());
    m_rawView->setFont(fixed);
    m_rawView->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setModel(&m_recognised);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(tableRowHeight);
    m_table->horizontalHeader()->setDefaultSectionSize(columnWidth);
    m_table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    m_noCurve->setAlignment(Qt::AlignCenter);
    for (QWidget *curve :
         std::initializer_list<QWidget *>{m_curveCanvas, m_circleCanvas, m_lineView, m_noCurve})
        m_curves->addWidget(curve);
    auto *table = new QWidget(this);
    inColumn(table, noMargins, 4, {m_columns, {m_table, 1}});
    auto *middle = new QSplitter(this);
    middle->setChildrenCollapsible(false);
    middle->addWidget(part(middle, m_rawTitle, m_rawSize, m_rawView));
    middle->addWidget(part(middle, m_tableTitle, m_tableSize, table));
    middle->addWidget(part(middle, m_curveTitle, m_zoom, m_curves));
    middle->setSizes({427, 427, 427});
    return middle;
}

QWidget *ImportAssistant::makeRemarks() {
    m_remarksPlace = made<QScrollArea>("importRemarks", this);
    m_remarksPlace->setWidget(m_remarks);
    m_remarksPlace->setWidgetResizable(true);
    m_remarksPlace->setFrameShape(QFrame::NoFrame);
    m_remarksPlace->setFixedHeight(remarksHeight);
    auto *whole = new QWidget(this);
    auto *head = inRow(styleSpacing, {{m_remarksTitle, 1}, m_confirmAll});
    inColumn(whole, noMargins, styleSpacing, {head, m_remarksPlace});
    return whole;
}

void ImportAssistant::connectAll() {
    connect(m_work, &WorkBar::cancelled, this, &ImportAssistant::cancelReading);
    connect(m_columns, &ColumnRoles::rolesChosen, this,
            [this](const QString &columns) { choose("columns", columns.toStdString()); });
    connect(m_remarks, &RemarkList::answered, this, [this](const QString &key, const QString &word) {
        choose(key.toStdString(), word.toStdString());
    });
    connect(m_remarks, &RemarkList::answerWanted, this, &ImportAssistant::showAnswerOf);
    connect(m_remarks, &RemarkList::lineWanted, this, &ImportAssistant::showLine);
    connect(m_confirmAll, &QPushButton::clicked, this, &ImportAssistant::confirmAll);
    connect(m_rawView, &QListView::clicked, this, &ImportAssistant::readTableAt);
    connect(m_rawView, &QListView::activated, this, &ImportAssistant::readTableAt); // with the keyboard
    connect(m_profile, &QComboBox::activated, this, [this](int index) {
        if (index == 0)
            takeOptions({});
        else
            useProfile(m_profile->itemText(index));
    });
    connect(m_saveProfile, &QPushButton::clicked, this, &ImportAssistant::askProfileName);
    connect(m_other, &QPushButton::clicked, this, &ImportAssistant::chooseOther);
    connect(m_paste, &QPushButton::clicked, this, &ImportAssistant::pasteText);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_import, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_curveCanvas, &FigureCanvas::rangesWanted, this, [this](const Interval &x, const Interval &y) {
        if (!m_curve)
            return;
        const auto [positions, values] = rangesWithin(*m_curve, x, y);
        m_curveCanvas->setFigure(withRanges(*m_curve, positions, values, windowLanguage()), {});
    });
    connect(m_curveCanvas, &FigureCanvas::fitWanted, this, [this] {
        if (m_curve)
            m_curveCanvas->setFigure(*m_curve, {});
    });
    connect(m_zoom, &ZoomButtons::zoomWanted, this, [this](int steps) {
        if (m_curves->currentWidget() == m_circleCanvas)
            m_circleCanvas->zoomBy(steps);
        else
            m_curveCanvas->zoomBy(steps);
    });
    connect(m_zoom, &ZoomButtons::fitWanted, this, [this] {
        m_circleCanvas->fit();
        emit m_curveCanvas->fitWanted();
    });
    // Both views start at the top of the file and scroll together.
    connect(m_rawView->verticalScrollBar(), &QScrollBar::valueChanged, this, [this](int value) {
        const int lines = std::max(m_rawView->verticalScrollBar()->maximum(), 1);
        m_table->verticalScrollBar()->setValue(
            static_cast<int>(qint64(m_table->verticalScrollBar()->maximum()) * value / lines));
    });
}

bool ImportAssistant::wantsNewDocument() const {
    return !m_document || m_destination->currentIndex() == 1;
}

Document ImportAssistant::destination() const {
    return wantsNewDocument() ? Document() : *m_document;
}

/// Returns a function that adds the measurement to a document on any thread; it holds only the data needed.
std::function<std::variant<Document, Error>(Document)> ImportAssistant::taking() const {
    Imported taken; // without the table as read and the test, which may be large
    taken.remarks = m_file.imported.remarks;
    taken.sensors = m_file.imported.sensors;
    taken.gradientPerHour = m_file.imported.gradientPerHour;
    taken.seriesStart = m_file.imported.seriesStart;
    taken.machine = m_file.imported.machine;
    taken.instruments = m_file.imported.instruments;
    taken.operatorName = m_file.imported.operatorName;
    return [taken = std::move(taken), test = m_file.test, bytes = m_file.bytes, name = m_file.name,
            keep = m_keep->isChecked()](Document document) -> std::variant<Document, Error> {
        Imported imported = taken;
        if (test)
            imported.test = *test;
        try {
            addImported(document, std::move(imported), bytes, name, keep);
        } catch (const Error &error) {
            return error;
        }
        return document;
    };
}

void ImportAssistant::addTo(Document &document) const {
    if (m_taken && document == destination()) {
        document = *m_taken;
        return;
    }
    auto outcome = taking()(document);
    if (const auto *error = std::get_if<Error>(&outcome))
        throw *error; // NOLINT(cert-err09-cpp,cert-err61-cpp): that of addImported
    document = std::move(std::get<Document>(outcome));
}

/// Reads small files at once.
void ImportAssistant::read(const QByteArray &bytes, const QString &name, const ImportOptions &options,
                           std::function<void(std::variant<MeasurementFile, Error>)> take) {
    using Outcome = std::variant<MeasurementFile, Error>;
    const auto work = [bytes, name, options]() -> Outcome {
        try {
            return readMeasurementFile(bytes, name, options);
        } catch (const Error &error) {
            return error;
        }
    };
    m_reader.cancel(); // only the latest request matters
    if (!isLargeFile(bytes.size())) {
        m_work->end();
        take(work());
        return;
    }
    m_reader.start([work](const Background::Job &) { return work(); },
                   [this, take = std::move(take)](Outcome outcome) {
                       m_work->end();
                       take(std::move(outcome));
                   });
    m_work->begin(tr("Reading %1…").arg(name));
    showState();
}

/// The displayed data were read with the current options.
void ImportAssistant::settle() {
    m_settled = m_options;
    m_settledProfile = m_profile->currentIndex() > 0 ? m_profile->currentText() : QString();
}

void ImportAssistant::cancelReading() {
    m_reader.cancel();
    m_work->end();
    m_options = m_settled;
    m_profile->setCurrentIndex(std::max(m_profile->findText(m_settledProfile), 0));
    refresh();
}

void ImportAssistant::takeFile(const QByteArray &bytes, const QString &fileName) {
    const QString name = QFileInfo(fileName).fileName();
    const bool couldImport = m_import->isEnabled();
    read(bytes, name, {}, [this, name, couldImport](std::variant<MeasurementFile, Error> outcome) {
        if (const auto *error = std::get_if<Error>(&outcome)) {
            refuse(*error, name);
            showRemarks();
            m_import->setEnabled(couldImport); // for the data read before
            return;
        }
        takeOther(std::move(std::get<MeasurementFile>(outcome)));
    });
}

void ImportAssistant::takeOther(MeasurementFile file) {
    takeRead(std::move(file));
    m_options.clear();
    m_profile->setCurrentIndex(0);
    settle();
    retranslate();
    useLastProfile();
}

void ImportAssistant::setFollowing(qsizetype files) {
    m_following = static_cast<int>(files);
    sayOrigin();
}

void ImportAssistant::sayOrigin() {
    const QString hash = QString::fromStdString(m_file.hash);
    QString origin =
        QStringLiteral("%1 · SHA-256 %2…%3")
            .arg(QLocale().formattedDataSize(m_file.bytes.size(), 1), hash.left(4), hash.right(4));
    if (m_following > 0)
        origin += QStringLiteral(" · ") + tr("%n file(s) follow", nullptr, m_following);
    m_origin->setText(origin);
    m_origin->setToolTip(hash);
}

void ImportAssistant::pasteText() {
    takeFile(clipboardText().toUtf8(), tr("clipboard"));
}

void ImportAssistant::chooseOther() {
    auto *dialog = made<QFileDialog>("otherDialog", this, tr("Import another file"),
                                     QSettings().value(QStringLiteral("window/importFolder")).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        try {
            takeFile(awaited([&] { return readBytes(path); }), path);
        } catch (const Error &error) {
            refuse(error, QFileInfo(path).fileName());
            showRemarks();
        }
    });
    dialog->open();
}

void ImportAssistant::choose(const std::string &key, const std::string &value) {
    ImportOptions options = m_options;
    if (value.empty())
        options.erase(key);
    else
        options[key] = value;
    takeOptions(std::move(options));
}

/// Reads the table at that place if a text has several.
void ImportAssistant::readTableAt(const QModelIndex &place) {
    const auto table = m_raw.tableAt(place.row());
    if (!table || m_raw.isRead(*table))
        return;
    const std::size_t line = m_raw.lineNumber(place.row());
    choose("table", std::to_string(*table + 1));
    showLine(line);
}

void ImportAssistant::confirmAll() {
    // Confirms only what is asked now: an answer may raise another question, which must be read first.
    ImportOptions options = m_options;
    for (const Question &question : m_file.imported.questions) {
        if (canBeConfirmed(question))
            options[question.id] = question.proposal;
    }
    for (const Remark &remark : m_file.imported.remarks) {
        if (const ImportChoice *guess = guessOf(remark, m_file.imported))
            options[guess->key] = guess->value;
    }
    takeOptions(std::move(options));
}

/// Replaces the displayed data, with the reason if they contain no measurement.
void ImportAssistant::takeRead(MeasurementFile file) {
    m_raw.clear();
    m_recognised.show(nullptr);
    m_file = std::move(file);
    m_refusal.reset();
    if (m_file.imported.refusal)
        refuse(*m_file.imported.refusal, {});
}

/// Reads the file again. If it cannot be read with these choices, they stay visible with the reason and can
/// be changed but not accepted.
void ImportAssistant::takeOptions(ImportOptions options) {
    m_options = std::move(options);
    read(m_file.bytes, m_file.name, m_options, [this](std::variant<MeasurementFile, Error> outcome) {
        if (const auto *error = std::get_if<Error>(&outcome)) {
            refuse(*error, {}); // nothing new to show: keep the last data
            std::erase_if(m_file.imported.questions,
                          [this](const Question &question) { return m_options.contains(question.id); });
        } else {
            takeRead(std::move(std::get<MeasurementFile>(outcome)));
        }
        settle();
        refresh();
    });
}

/// `file`: name of the file if it is another one; may be empty.
void ImportAssistant::refuse(const Error &error, const QString &file) {
    QString sentence = windowLanguage().sentence(error.message);
    for (const QString &where : {QString::fromStdString(error.place), file}) {
        if (!where.isEmpty())
            sentence = tr("%1: %2").arg(where, sentence);
    }
    m_refusal = sentence;
}

void ImportAssistant::useLastProfile() {
    const QString last = QSettings().value(profileSetting(m_file.name)).toString();
    if (m_profiles.contains(last.toStdString()))
        useProfile(last);
}

void ImportAssistant::useProfile(const QString &name) {
    const auto found = m_profiles.find(name.toStdString());
    if (found == m_profiles.end())
        return;
    m_profile->setCurrentIndex(m_profile->findText(name));
    takeOptions(found->second);
}

void ImportAssistant::fillProfiles(const QString &current) {
    m_profile->clear();
    m_profile->addItem(tr("none"));
    for (const auto &[name, options] : m_profiles)
        m_profile->addItem(QString::fromStdString(name));
    m_profile->setCurrentIndex(std::max(m_profile->findText(current), 0));
}

void ImportAssistant::askProfileName() {
    auto *dialog = made<QInputDialog>("profileDialog", this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save the choices"));
    dialog->setLabelText(tr("Name of the profile"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &name) {
        if (!name.trimmed().isEmpty())
            saveProfile(name.trimmed());
    });
    dialog->open();
}

bool ImportAssistant::saveProfile(const QString &name) {
    ImportOptions options;
    for (const ImportChoice &choice : m_file.imported.choices) {
        if (choice.origin == Origin::chosen && !choice.value.empty())
            options[choice.key] = choice.value;
    }
    try {
        ImportProfiles profiles = readImportProfiles(importProfilesPath());
        profiles[name.toStdString()] = options;
        saveImportProfiles(profiles, importProfilesPath());
        m_profiles = std::move(profiles);
    } catch (const Error &error) {
        showError(this, tr("The profile cannot be saved"), error);
        return false;
    }
    fillProfiles(name);
    return true;
}

/// The choices relevant to the file, in display order, except column roles, which are shown above the
/// columns. For an unreadable file, the choices made and the sheets, as one of them may be the cause.
std::vector<ImportChoice> ImportAssistant::shownChoices() const {
    std::vector<ImportChoice> shown;
    for (const ImportKey &key : importKeys()) {
        const auto found = std::ranges::find(m_file.imported.choices, key.key, &ImportChoice::key);
        const auto chosen = m_options.find(key.key);
        const bool isSheet = key.key == std::string_view("sheet") && !m_file.imported.sheets.empty();
        if (key.key == std::string_view("columns"))
            continue;
        if (found != m_file.imported.choices.end())
            shown.push_back(*found);
        else if (m_refusal && chosen != m_options.end())
            shown.push_back({key.key, chosen->second, Origin::chosen});
        else if (m_refusal && isSheet)
            shown.push_back({key.key, {}, Origin::recognised});
    }
    return shown;
}

/// The sheets of the workbook, hidden ones last and marked as such.
void ImportAssistant::fillSheets(QComboBox &sheets) const {
    for (const ImportSheet &sheet : m_file.imported.sheets) {
        const QString name = QString::fromStdString(sheet.name);
        sheets.addItem(sheet.isHidden ? tr("%1 (hidden)").arg(name) : name, name);
    }
}

void ImportAssistant::makeBoxes() {
    for (const Box &box : m_boxes) {
        if (!box.cell)
            continue;
        box.cell->deleteLater(); // the sender may be in one of them
        box.cell->hide();
    }
    m_boxes.clear();
    for (const ImportChoice &choice : shownChoices())
        m_boxes.push_back(makeBox(choice));
    m_boxColumns = boxColumns();
    placeBoxes();
}

/// Remaining boxes keep their place and the focus; new ones fill freed places, otherwise they are appended.
void ImportAssistant::changeBoxes(const std::vector<ImportChoice> &shown) {
    for (Box &box : m_boxes) {
        if (box.key.empty() || std::ranges::find(shown, box.key, &ImportChoice::key) != shown.end())
            continue;
        box.cell->hide();
        box.cell->deleteLater(); // the sender may be in it
        box = Box();
    }
    for (const ImportChoice &choice : shown) {
        if (std::ranges::find(m_boxes, choice.key, &Box::key) != m_boxes.end())
            continue;
        const auto gap = std::ranges::find(m_boxes, std::string(), &Box::key);
        if (gap != m_boxes.end())
            *gap = makeBox(choice);
        else
            m_boxes.push_back(makeBox(choice));
    }
    m_boxColumns = std::min(m_boxColumns, boxColumns()); // a name may be longer now
    placeBoxes();
}

ImportAssistant::Box ImportAssistant::makeBox(const ImportChoice &choice) {
    const ImportKey *key = findImportKey(choice.key);
    Box box{choice.key, new QWidget(this), nullptr, nullptr, nullptr, nullptr};
    box.cell->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // makes columns equally wide
    box.name = new QLabel(windowLanguage().text(key->name), box.cell);
    box.badge = new QLabel(tr("guessed"), box.cell);
    box.badge->setObjectName(QStringLiteral("guessed.") + QString::fromStdString(choice.key));
    QWidget *control = nullptr;
    const bool isSheet = choice.key == "sheet" && !m_file.imported.sheets.empty();
    if (key->value == ImportValue::word || isSheet || choice.key == "edition") {
        box.words = new ElidedBox(box.cell);
        box.words->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box.words->setMinimumContentsLength(boxContents);
        if (isSheet)
            fillSheets(*box.words);
        for (const ImportWord &word : key->words)
            box.words->addItem(windowLanguage().text(word.name), QString::fromLatin1(word.word));
        connect(box.words, &QComboBox::activated, this, [this, words = box.words, name = choice.key] {
            choose(name, words->currentData().toString().toStdString());
        });
        control = box.words;
    } else {
        box.edit = new QLineEdit(box.cell);
        connect(box.edit, &QLineEdit::editingFinished, this, [this, edit = box.edit, name = choice.key] {
            if (edit->isModified())
                choose(name, asTyped(edit->text()));
        });
        control = box.edit;
    }
    control->setObjectName(QStringLiteral("import.") + QString::fromStdString(choice.key));
    control->setAccessibleName(box.name->text());
    auto *head = inRow(styleSpacing, {{box.name, 1}, box.badge});
    inColumn(box.cell, noMargins, 2, {head, control});
    return box;
}

/// Lists the editions of the kind of test, as for a new test.
void ImportAssistant::fillEditions(QComboBox &editions) const {
    const auto kind = std::ranges::find(m_file.imported.choices, "kind", &ImportChoice::key);
    std::optional<Kind> of;
    if (m_file.imported.test)
        of = kindOf(*m_file.imported.test);
    for (const auto &row : fileWords<Kind>) {
        if (!of && kind != m_file.imported.choices.end() && kind->value == row.word)
            of = row.value;
    }
    editions.clear();
    for (const Edition *edition : palmer::editions()) {
        if (!of || edition->kind == *of)
            editions.addItem(QString::fromUtf8(edition->word), QString::fromUtf8(edition->word));
    }
}

/// As many columns as fit into the dialog's width.
int ImportAssistant::boxColumns() const {
    int least = std::max(m_destinationName->parentWidget()->minimumSizeHint().width(),
                         m_profileName->parentWidget()->minimumSizeHint().width());
    for (const Box &box : m_boxes)
        least = std::max(least, box.cell ? box.cell->minimumSizeHint().width() : 0);
    const int margins = 2 * style()->pixelMetric(QStyle::PM_LayoutLeftMargin, nullptr, this);
    return std::clamp((width() - margins + boxSpacing) / (least + boxSpacing), 2, mostBoxColumns);
}

void ImportAssistant::placeBoxes() {
    while (QLayoutItem *item = m_choices->takeAt(0))
        delete item;
    int place = 0;
    const auto put = [&](QWidget *cell) {
        if (cell)
            m_choices->addWidget(cell, place / m_boxColumns, place % m_boxColumns);
        ++place;
    };
    for (const Box &box : m_boxes)
        put(box.cell);
    put(m_destinationName->parentWidget());
    put(m_profileName->parentWidget());
    for (int i = 0; i < mostBoxColumns; ++i)
        m_choices->setColumnStretch(i, i < m_boxColumns ? 1 : 0);
}

void ImportAssistant::resizeEvent(QResizeEvent *event) {
    QDialog::resizeEvent(event);
    m_remarksPlace->setFixedHeight(height() < lowBelow ? lowRemarksHeight : remarksHeight);
    if (const int columns = boxColumns(); columns != m_boxColumns) {
        m_boxColumns = columns;
        placeBoxes();
    }
}

void ImportAssistant::showChoices() {
    const std::vector<ImportChoice> shown = shownChoices();
    const auto isShown = [&](const Box &box) {
        return box.key.empty() || std::ranges::find(shown, box.key, &ImportChoice::key) != shown.end();
    };
    const auto hasBox = [&](const ImportChoice &choice) {
        return std::ranges::find(m_boxes, choice.key, &Box::key) != m_boxes.end();
    };
    if (!std::ranges::all_of(m_boxes, isShown) || !std::ranges::all_of(shown, hasBox))
        changeBoxes(shown);
    for (const Box &box : m_boxes) {
        if (box.key.empty())
            continue;
        const auto choice = std::ranges::find(shown, box.key, &ImportChoice::key);
        const auto chosen = m_options.find(box.key);
        const bool isChosen = chosen != m_options.end();
        showChoice(box, QString::fromStdString(isChosen ? chosen->second : choice->value),
                   !isChosen && choice->origin == Origin::guessed);
    }
}

void ImportAssistant::showChoice(const Box &box, const QString &value, bool guessed) {
    const QString unsure = token(Token::unsure, palette()).name();
    box.badge->setVisible(guessed);
    box.badge->setStyleSheet(QStringLiteral("background: %1; color: %2; border-radius: 6px; padding: 0 6px;")
                                 .arg(token(Token::unsureGround, palette()).name(), unsure));
    box.name->setMinimumHeight(box.badge->sizeHint().height()); // reserves its height, so that nothing moves
    QWidget *control = box.words ? static_cast<QWidget *>(box.words) : box.edit;
    control->setStyleSheet(guessed ? QStringLiteral("border-color: %1;").arg(unsure) : QString());
    control->setAccessibleDescription(guessed ? tr("guessed") : QString());
    if (!box.words) {
        box.edit->setText(findImportKey(box.key)->value == ImportValue::number ? asRead(value) : value);
        return;
    }
    if (box.key == "edition") {
        fillEditions(*box.words);
        if (!value.isEmpty() && box.words->findData(value) < 0)
            box.words->addItem(value, value); // of another kind of test; the reason is shown below
    }
    box.words->setCurrentIndex(box.words->findData(value));
    box.words->setToolTip(box.words->currentText()); // the full text, if the field is too narrow
}

void ImportAssistant::showLine(std::size_t line) {
    const QModelIndex at = m_raw.index(m_raw.rowOf(line));
    m_rawView->setCurrentIndex(at);
    m_rawView->scrollTo(at);
}

/// Focuses the place where a question without a list of answers is answered.
void ImportAssistant::showAnswerOf(const QString &key) {
    const auto box = std::ranges::find(m_boxes, key.toStdString(), &Box::key);
    QWidget *field = m_columns;
    if (box != m_boxes.end())
        field = box->words ? static_cast<QWidget *>(box->words) : box->edit;
    field->setFocus();
    if (auto *edit = qobject_cast<QLineEdit *>(field))
        edit->selectAll();
}

void ImportAssistant::showRemarks() {
    const QWidget *focused = focusWidget();
    const bool isAnswering = focused && (focused == m_confirmAll || m_remarks->isAncestorOf(focused));
    m_remarks->showRemarks(m_file.imported, m_refusal,
                           [this](std::size_t line) { return m_raw.rowOf(line) >= 0; });
    const auto questions = static_cast<int>(m_file.imported.questions.size());
    m_remarksTitle->setText(questions > 0 ? tr("%n question(s) to answer, and remarks", nullptr, questions)
                                          : tr("Remarks"));
    m_remarksPlace->setAccessibleName(m_remarksTitle->text());
    m_confirmAll->setVisible(std::ranges::count_if(m_file.imported.questions, canBeConfirmed) > 0);
    if (isAnswering && !m_remarks->focusFirst())
        m_import->setFocus();
}

void ImportAssistant::showCurve() {
    m_drawer.cancel();
    m_curve.reset();
    m_noCurve->setText(m_refusal ? tr("No measurement can be read yet: what is missing is said below.")
                                 : tr("There is no curve of this measurement."));
    m_curves->setCurrentWidget(m_noCurve);
    m_zoom->setEnabled(m_file.imported.test.has_value());
    if (!m_file.imported.test) {
        const LineFigure temperatures = temperatureFigure(m_file.imported.sensors, windowLanguage());
        m_lineView->setFigure(temperatures);
        if (!temperatures.lines.empty())
            m_curves->setCurrentWidget(m_lineView);
        return;
    }
    auto document = std::make_shared<Document>();
    document->tests.push_back(m_file.test);
    const auto work = [document = std::shared_ptr<const Document>(document), language = windowLanguage()] {
        EvaluatedDocument evaluated = evaluate(document);
        std::optional<CurveFigure> curve = curveOf(evaluated, language);
        return std::pair(std::move(evaluated), std::move(curve));
    };
    if (readingsOf(m_file.imported) <= static_cast<int>(fewReadings)) {
        const auto [evaluated, curve] = work();
        showEvaluated(evaluated, curve);
        return;
    }
    m_noCurve->setText(tr("Being drawn…"));
    m_drawer.start([work](const Background::Job &) { return work(); },
                   [this](const std::pair<EvaluatedDocument, std::optional<CurveFigure>> &drawn) {
                       showEvaluated(drawn.first, drawn.second);
                   });
}

/// `curve`: null for circles.
void ImportAssistant::showEvaluated(const EvaluatedDocument &evaluated, std::optional<CurveFigure> curve) {
    m_curve = std::move(curve);
    if (m_curve) {
        m_curveCanvas->setFigure(*m_curve, {});
        m_curves->setCurrentWidget(m_curveCanvas);
        return;
    }
    m_circleCanvas->show(evaluated, 0, {}, windowLanguage());
    m_curves->setCurrentWidget(m_circleCanvas);
}

QStringList ImportAssistant::sizesOf(const PositioningMeasurement &measurement) {
    QStringList sizes{tr("%n target(s)", nullptr, static_cast<int>(measurement.targets.size()))};
    for (const auto &[approach, arrow] :
         {std::pair(Direction::positive, u'↑'), std::pair(Direction::negative, u'↓')}) {
        const auto runs = std::ranges::count(measurement.runs, approach, &Run::approach);
        sizes << tr("%n run(s)", nullptr, static_cast<int>(runs)) + u' ' + arrow;
    }
    return sizes;
}

QStringList ImportAssistant::sizesOf(const CircularMeasurement &measurement) const {
    return {tr("%n arc(s)", nullptr, static_cast<int>(measurement.arcs.size())), pointsText()};
}

QStringList ImportAssistant::sizesOf(const DriftMeasurement & /*measurement*/) const {
    return {pointsText()};
}

QString ImportAssistant::pointsText() const {
    const int points = readingsOf(m_file.imported);
    return withGroups(tr("%n point(s)", nullptr, points), points);
}

void ImportAssistant::showSizes() {
    m_rawSize->setText(withGroups(tr("%n line(s)", nullptr, m_raw.rowCount()), m_raw.rowCount()));
    QStringList sizes;
    if (m_file.imported.test) {
        sizes = std::visit([this](const auto &measurement) { return sizesOf(measurement); },
                           m_file.imported.test->measurement);
    } else if (!m_file.imported.refusal) {
        sizes << tr("%n sensor(s)", nullptr, static_cast<int>(m_file.imported.sensors.size()));
    }
    m_tableSize->setText(sizes.join(QStringLiteral(" · ")));
}

void ImportAssistant::refresh() {
    m_raw.show(m_file.imported, m_file.lines);
    m_recognised.show(&m_file.imported);
    constexpr int mostWidened = 100;
    QHeaderView *const heads = m_table->horizontalHeader();
    for (int i = 0; i < std::min(heads->count(), mostWidened); ++i)
        heads->resizeSection(i, std::max(columnWidth, heads->sectionSizeHint(i)));
    m_columns->showColumns(m_file.imported.columns);
    showSizes();
    showChoices();
    showState();
    showRemarks(); // may focus the button that the state enables
    showCurve();
}

/// Shows the number of readings to import, or what prevents it.
void ImportAssistant::showState() {
    const int readings = readingsOf(m_file.imported);
    const auto questions = static_cast<int>(m_file.imported.questions.size());
    m_import->setText(withGroups(tr("&Import %n reading(s)", nullptr, readings), readings));
    m_import->setEnabled(!m_refusal && readings > 0 && questions == 0 && !m_reader.isBusy());
    const int missing = missingOf(m_file.imported);
    QStringList open;
    if (missing > 0)
        open << tr("%n missing reading(s)", nullptr, missing);
    if (questions > 0 && !m_refusal)
        open << tr("%n question(s) to answer", nullptr, questions);
    m_open->setText(open.join(QStringLiteral(" · ")));
    m_open->setStyleSheet(QStringLiteral("color: %1;").arg(token(Token::unsure, palette()).name()));
    m_import->setAccessibleDescription(m_open->text());
}

/// Takes a text still being typed, as a mnemonic does not leave the field.
void ImportAssistant::takeTyped() {
    for (const Box &box : m_boxes) {
        if (box.edit && box.edit->isModified()) {
            choose(box.key, asTyped(box.edit->text()));
            return; // at most one was still being typed, and the boxes may have been rebuilt
        }
    }
}

void ImportAssistant::accept() {
    takeTyped();
    if (!m_import->isEnabled())
        return;
    const auto work = [take = taking(), document = destination()] { return take(document); };
    if (!isLargeFile(m_file.bytes.size())) {
        finish(work());
        return;
    }
    m_reader.start([work](const Background::Job &) { return work(); },
                   [this](std::variant<Document, Error> outcome) {
                       m_work->end();
                       finish(std::move(outcome));
                   });
    m_work->begin(tr("Importing %1…").arg(m_file.name));
    showState();
}

/// Closes with the resulting document, or shows why the measurement cannot be added.
void ImportAssistant::finish(std::variant<Document, Error> outcome) {
    if (const auto *error = std::get_if<Error>(&outcome)) {
        refuse(*error, {});
        showRemarks();
        showState();
        return;
    }
    m_taken = std::move(std::get<Document>(outcome));
    QSettings settings;
    settings.setValue(QStringLiteral("import/keepBytes"), m_keep->isChecked());
    settings.setValue(profileSetting(m_file.name),
                      m_profile->currentIndex() > 0 ? m_profile->currentText() : QString());
    QDialog::accept();
}

void ImportAssistant::retranslate() {
    setWindowTitle(tr("Import"));
    m_other->setText(tr("&Other file…"));
    m_paste->setText(tr("&Paste text"));
    m_title->setText(tr("Import %1").arg(m_file.name));
    sayOrigin();
    m_destinationName->setText(tr("Destination"));
    const int destination = m_destination->currentIndex();
    m_destination->clear();
    if (m_document)
        m_destination->addItem(tr("the open file"));
    m_destination->addItem(tr("a new file"));
    m_destination->setCurrentIndex(std::max(destination, 0));
    m_destination->setAccessibleName(m_destinationName->text());
    m_profileName->setText(tr("Profile"));
    m_profile->setAccessibleName(m_profileName->text());
    fillProfiles(m_profile->currentIndex() > 0 ? m_profile->currentText() : QString());
    m_rawTitle->setText(tr("Text as read"));
    m_rawView->setAccessibleName(m_rawTitle->text());
    m_tableTitle->setText(tr("Recognised table"));
    m_table->setAccessibleName(m_tableTitle->text());
    m_curveTitle->setText(tr("Curve"));
    m_curveCanvas->setAccessibleName(m_curveTitle->text());
    m_circleCanvas->setAccessibleName(m_curveTitle->text());
    m_lineView->setAccessibleName(m_curveTitle->text());
    m_columns->setAccessibleName(tr("Roles of the columns"));
    m_remarks->setAccessibleName(tr("Questions and remarks"));
    m_confirmAll->setText(tr("Confirm &all"));
    m_confirmAll->setToolTip(tr(
        "Takes what is proposed to each assumed question and remark; a doubtful one wants its own answer"));
    m_keep->setText(tr("&Keep the original in the file"));
    m_saveProfile->setText(tr("&Save these choices as a profile…"));
    m_cancel->setText(tr("&Cancel"));
    if (m_file.imported.refusal)
        refuse(*m_file.imported.refusal, {});
    makeBoxes(); // in the new language
    refresh();
}

} // namespace palmer::ui
