#include "ui/import/importassistant.h"

#include "document/savedocument.h"
#include "figures/deviationfigure.h"
#include "figures/driftfigure.h"
#include "figures/linefigure.h"
#include "ui/figures/circlecanvas.h"
#include "ui/figures/figurecanvas.h"
#include "ui/figures/lineview.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int boxColumns = 6;
constexpr int rowHeight = 26;
constexpr int remarksHeight = 150;
constexpr std::size_t remarksShown = 200; ///< a file of a million broken cells has as many remarks

/// A title over a part, what is said of its size at the right, and the part.
QWidget *part(QWidget *parent, QLabel *title, QLabel *size, QWidget *content) {
    auto *whole = new QWidget(parent);
    whole->setProperty("ground", QStringLiteral("base"));
    auto *column = new QVBoxLayout(whole);
    column->setContentsMargins(12, 8, 4, 4);
    title->setFont(themeFont(TextSize::head));
    auto *head = new QHBoxLayout;
    head->addWidget(title, 1);
    if (size) {
        size->setProperty("secondary", true);
        head->addWidget(size);
        head->addSpacing(8);
    }
    column->addLayout(head);
    column->addWidget(content, 1);
    return whole;
}

/// The mark before a remark: its shape says what its colour says.
class GradeIcon : public QWidget {
public:
    GradeIcon(RemarkGrade grade, QWidget *parent)
        : QWidget(parent)
        , m_grade(grade) {
        setFixedSize(16, 16);
    }

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        const auto draw = [&](const char *icon, Token colour) {
            drawLineIcon(painter, rect(), QLatin1StringView(icon), token(colour, palette()));
        };
        switch (m_grade) {
        case RemarkGrade::problem:
            draw("miss", Token::bad);
            break;
        case RemarkGrade::assumption:
            draw("warn", Token::unsure);
            break;
        case RemarkGrade::note:
            draw("info", Token::secondaryText);
            break;
        }
    }

private:
    RemarkGrade m_grade;
};

QPushButton *addLink(QHBoxLayout &row, const QString &words, const QString &sentence) {
    auto *button = new QPushButton(words);
    button->setProperty("link", true);
    button->setAutoDefault(false);
    button->setAccessibleName(QStringLiteral("%1 – %2").arg(words, sentence));
    row.addWidget(button);
    return button;
}

QString profileSetting(const QString &fileName) {
    return QStringLiteral("import/profiles/") + QFileInfo(fileName).suffix().toLower();
}

} // namespace

ImportAssistant::ImportAssistant(QByteArray bytes, const QString &fileName, const Document *open,
                                 QWidget *parent)
    : QDialog(parent)
    , m_bytes(std::move(bytes))
    , m_fileName(QFileInfo(fileName).fileName())
    , m_imported(importMeasurement(m_bytes, m_fileName))
    , m_title(new QLabel(this))
    , m_origin(new QLabel(this))
    , m_other(new QPushButton(this))
    , m_paste(new QPushButton(this))
    , m_choices(new QGridLayout)
    , m_destinationName(new QLabel(this))
    , m_destination(new QComboBox(this))
    , m_profileName(new QLabel(this))
    , m_profile(new QComboBox(this))
    , m_rawTitle(new QLabel(this))
    , m_rawSize(new QLabel(this))
    , m_rawView(new QListView(this))
    , m_tableTitle(new QLabel(this))
    , m_tableSize(new QLabel(this))
    , m_table(new QTableView(this))
    , m_curveTitle(new QLabel(this))
    , m_curves(new QStackedWidget(this))
    , m_curveCanvas(new FigureCanvas(m_selection, m_curves))
    , m_circleCanvas(new CircleCanvas(m_selection, m_curves))
    , m_lineView(new LineView(m_curves))
    , m_noCurve(new QLabel(m_curves))
    , m_remarksTitle(new QLabel(this))
    , m_remarks(new QVBoxLayout)
    , m_keep(new QCheckBox(this))
    , m_saveProfile(new QPushButton(this))
    , m_open(new QLabel(this))
    , m_cancel(new QPushButton(this))
    , m_import(new QPushButton(this)) {
    if (open)
        m_document = *open;
    setObjectName(QStringLiteral("importAssistant"));
    resize(sizeOnScreen(*this, {1280, 800}));
    try {
        m_profiles = readImportProfiles(importProfilesPath());
    } catch (const Error &) {
        m_profiles.clear(); // a damaged file of profiles hinders no import; saving one says what is wrong
    }
    makeLayout();
    m_rawView->setFocus();
    m_keep->setChecked(QSettings().value(QStringLiteral("import/keepBytes")).toBool());
    retranslate();
    useLastProfile();
}

void ImportAssistant::makeLayout() {
    m_title->setFont(themeFont(TextSize::title));
    m_title->setTextFormat(Qt::PlainText);
    m_origin->setProperty("secondary", true);
    auto *head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addWidget(m_origin);
    head->addStretch();
    m_other->setObjectName(QStringLiteral("importOther"));
    m_paste->setObjectName(QStringLiteral("importPaste"));
    head->addWidget(m_other);
    head->addWidget(m_paste);
    m_choices->setHorizontalSpacing(12);
    m_choices->setVerticalSpacing(6);

    m_destination->setObjectName(QStringLiteral("import.destination"));
    m_profile->setObjectName(QStringLiteral("import.profile"));
    m_rawView->setObjectName(QStringLiteral("importRaw"));
    m_rawView->setModel(&m_raw);
    m_rawView->setItemDelegate(new RawTextDelegate(m_rawView));
    m_rawView->setUniformItemSizes(true);
    m_rawView->setFrameShape(QFrame::NoFrame);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(font().pointSizeF());
    m_rawView->setFont(fixed);
    m_rawView->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setObjectName(QStringLiteral("importTable"));
    m_table->setModel(&m_recognised);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->horizontalHeader()->setDefaultSectionSize(72);
    m_table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    m_curveCanvas->setObjectName(QStringLiteral("importCurve"));
    m_circleCanvas->setObjectName(QStringLiteral("importCircle"));
    m_noCurve->setAlignment(Qt::AlignCenter);
    m_noCurve->setWordWrap(true);
    m_noCurve->setProperty("secondary", true);
    m_curves->addWidget(m_curveCanvas);
    m_curves->addWidget(m_circleCanvas);
    m_curves->addWidget(m_lineView);
    m_curves->addWidget(m_noCurve);
    auto *middle = new QSplitter(this);
    middle->setChildrenCollapsible(false);
    middle->addWidget(part(middle, m_rawTitle, m_rawSize, m_rawView));
    middle->addWidget(part(middle, m_tableTitle, m_tableSize, m_table));
    middle->addWidget(part(middle, m_curveTitle, nullptr, m_curves));
    middle->setSizes({427, 427, 427});

    auto *remarks = new QWidget(this);
    remarks->setProperty("ground", QStringLiteral("base"));
    m_remarks->setContentsMargins(12, 0, 12, 4);
    m_remarks->setSpacing(0);
    remarks->setLayout(m_remarks);
    auto *scroll = new QScrollArea(this);
    scroll->setObjectName(QStringLiteral("importRemarks"));
    scroll->setWidget(remarks);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedHeight(remarksHeight);
    m_remarksTitle->setFont(themeFont(TextSize::head));

    m_keep->setObjectName(QStringLiteral("keepBytes"));
    m_saveProfile->setObjectName(QStringLiteral("saveProfile"));
    m_open->setObjectName(QStringLiteral("importOpen"));
    m_cancel->setObjectName(QStringLiteral("cancelImport"));
    m_import->setObjectName(QStringLiteral("acceptImport"));
    m_import->setProperty("primary", true);
    auto *foot = new QHBoxLayout;
    foot->addWidget(m_keep);
    foot->addSpacing(24);
    foot->addWidget(m_saveProfile);
    foot->addStretch();
    foot->addWidget(m_open);
    foot->addWidget(m_cancel);
    foot->addWidget(m_import);
    for (QPushButton *button : {m_other, m_paste, m_saveProfile, m_cancel, m_import})
        button->setAutoDefault(false);

    auto *layout = new QVBoxLayout(this);
    layout->addLayout(head);
    layout->addLayout(m_choices);
    layout->addWidget(middle, 1);
    layout->addWidget(m_remarksTitle);
    layout->addWidget(scroll);
    layout->addLayout(foot);

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
        if (m_curve)
            m_curveCanvas->setFigure(withRanges(*m_curve, x, y, windowLanguage()), {});
    });
    connect(m_curveCanvas, &FigureCanvas::fitWanted, this, [this] {
        if (m_curve)
            m_curveCanvas->setFigure(*m_curve, {});
    });
    // Both show the same file from above: they scroll together.
    connect(m_rawView->verticalScrollBar(), &QScrollBar::valueChanged, this, [this](int value) {
        const int lines = std::max(m_rawView->verticalScrollBar()->maximum(), 1);
        m_table->verticalScrollBar()->setValue(
            static_cast<int>(qint64(m_table->verticalScrollBar()->maximum()) * value / lines));
    });
}

bool ImportAssistant::wantsNewDocument() const {
    return !m_document || m_destination->currentIndex() == 1;
}

void ImportAssistant::addTo(Document &document) const {
    addImported(document, m_imported, m_bytes, m_fileName, m_keep->isChecked());
}

void ImportAssistant::takeFile(const QByteArray &bytes, const QString &fileName) {
    const QString name = QFileInfo(fileName).fileName();
    m_refusal.reset();
    try {
        Imported imported = importMeasurement(bytes, name);
        m_raw.show(nullptr);
        m_recognised.show(nullptr);
        m_imported = std::move(imported);
        m_bytes = bytes;
        m_fileName = name;
        m_options.clear();
        m_profile->setCurrentIndex(0);
        retranslate();
        useLastProfile();
    } catch (const Error &error) {
        refuse(error, name);
        showRemarks();
    }
}

void ImportAssistant::pasteText() {
    takeFile(QGuiApplication::clipboard()->text().toUtf8(), tr("clipboard"));
}

void ImportAssistant::chooseOther() {
    auto *dialog = new QFileDialog(this, tr("Import another file"),
                                   QSettings().value(QStringLiteral("window/importFolder")).toString());
    dialog->setObjectName(QStringLiteral("otherDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        try {
            takeFile(readBytes(path), path);
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

void ImportAssistant::confirm(const std::string &key) {
    const auto found = std::ranges::find(m_imported.choices, key, &ImportChoice::key);
    if (found != m_imported.choices.end())
        choose(key, found->value);
}

/// Reads the file anew. Choices under which it cannot be read stay visible with the reason, beside what was
/// read last; they can be changed, but not accepted.
void ImportAssistant::takeOptions(ImportOptions options) {
    m_options = std::move(options);
    m_refusal.reset();
    try {
        Imported imported = importMeasurement(m_bytes, m_fileName, m_options);
        m_raw.show(nullptr);
        m_imported = std::move(imported);
    } catch (const Error &error) {
        refuse(error, {});
    }
    refresh();
}

/// `file`: where it is not the one at hand.
void ImportAssistant::refuse(const Error &error, const QString &file) {
    QString sentence = windowLanguage().sentence(error.message);
    for (const QString &where : {QString::fromStdString(error.place), file}) {
        if (!where.isEmpty())
            sentence = tr("%1: %2").arg(where, sentence);
    }
    m_refusal = sentence;
}

void ImportAssistant::useLastProfile() {
    const QString last = QSettings().value(profileSetting(m_fileName)).toString();
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
    auto *dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("profileDialog"));
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
    for (const ImportChoice &choice : m_imported.choices) {
        if (choice.origin != Origin::recognised && !choice.value.empty())
            options[choice.key] = choice.value;
    }
    try {
        ImportProfiles profiles = readImportProfiles(importProfilesPath());
        profiles[name.toStdString()] = options;
        saveImportProfiles(profiles, importProfilesPath());
        m_profiles = std::move(profiles);
    } catch (const Error &error) {
        auto *box = new QMessageBox(QMessageBox::Critical, windowTitle(), tr("The profile cannot be saved"),
                                    QMessageBox::Ok, this);
        box->setObjectName(QStringLiteral("errorBox"));
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setInformativeText(windowLanguage().sentence(error.message));
        box->open();
        return false;
    }
    fillProfiles(name);
    return true;
}

/// Those that matter for the file, in the order in which choices are shown.
std::vector<ImportChoice> ImportAssistant::shownChoices() const {
    std::vector<ImportChoice> shown;
    for (const ImportKey &key : importKeys()) {
        const auto found = std::ranges::find(m_imported.choices, key.key, &ImportChoice::key);
        if (found != m_imported.choices.end())
            shown.push_back(*found);
    }
    return shown;
}

void ImportAssistant::makeBoxes() {
    for (const Box &box : m_boxes)
        box.cell->deleteLater(); // one of them may be what asked for this
    for (const Box &box : m_boxes)
        box.cell->hide();
    m_boxes.clear();
    while (QLayoutItem *item = m_choices->takeAt(0))
        delete item;
    int place = 0;
    const auto put = [&](QLayout *cell) {
        m_choices->addLayout(cell, place / boxColumns, place % boxColumns);
        ++place;
    };
    for (const ImportChoice &choice : shownChoices()) {
        const ImportKey *key = findImportKey(choice.key);
        Box box{choice.key, new QWidget(this), nullptr, nullptr, nullptr, nullptr};
        box.name = new QLabel(windowLanguage().text(key->name), box.cell);
        box.badge = new QLabel(tr("guessed"), box.cell);
        box.badge->setObjectName(QStringLiteral("guessed.") + QString::fromStdString(choice.key));
        QWidget *control = nullptr;
        if (key->value == ImportValue::word) {
            box.words = new QComboBox(box.cell);
            box.words->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
            box.words->setMinimumContentsLength(12);
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
                    choose(name, edit->text().trimmed().toStdString());
            });
            control = box.edit;
        }
        control->setObjectName(QStringLiteral("import.") + QString::fromStdString(choice.key));
        control->setAccessibleName(box.name->text());
        auto *head = new QHBoxLayout;
        head->addWidget(box.name, 1);
        head->addWidget(box.badge);
        auto *column = new QVBoxLayout(box.cell);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(2);
        column->addLayout(head);
        column->addWidget(control);
        m_choices->addWidget(box.cell, place / boxColumns, place % boxColumns);
        ++place;
        m_boxes.push_back(box);
    }
    const auto column = [](QLabel *name, QComboBox *words) {
        auto *layout = new QVBoxLayout;
        layout->setSpacing(2);
        layout->addWidget(name);
        layout->addWidget(words);
        return layout;
    };
    put(column(m_destinationName, m_destination));
    put(column(m_profileName, m_profile));
    for (int i = 0; i < boxColumns; ++i)
        m_choices->setColumnStretch(i, 1);
}

void ImportAssistant::showChoices() {
    const bool same = std::ranges::equal(shownChoices(), m_boxes, {}, &ImportChoice::key, &Box::key);
    if (!same)
        makeBoxes();
    const QString unsure = token(Token::unsure, palette()).name();
    const QString ground = token(Token::unsureGround, palette()).name();
    for (const Box &box : m_boxes) {
        const auto choice = std::ranges::find(m_imported.choices, box.key, &ImportChoice::key);
        const auto chosen = m_options.find(box.key);
        const QString value =
            QString::fromStdString(chosen != m_options.end() ? chosen->second : choice->value);
        const bool guessed = choice->origin == Origin::guessed && chosen == m_options.end();
        box.badge->setVisible(guessed);
        box.badge->setStyleSheet(
            QStringLiteral("background: %1; color: %2; border-radius: 6px; padding: 0 6px;")
                .arg(ground, unsure));
        QWidget *control = box.words ? static_cast<QWidget *>(box.words) : box.edit;
        control->setStyleSheet(guessed ? QStringLiteral("border-color: %1;").arg(unsure) : QString());
        control->setAccessibleDescription(guessed ? tr("guessed") : QString());
        if (box.words)
            box.words->setCurrentIndex(box.words->findData(value));
        else
            box.edit->setText(value);
    }
}

QHBoxLayout *ImportAssistant::addRow(RemarkGrade grade, QString sentence, std::size_t line,
                                     std::size_t column, std::size_t times) {
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 2, 0, 2);
    auto *icon = new GradeIcon(grade, row);
    if (times > 1)
        sentence += QStringLiteral(" (× %1)").arg(times);
    if (line > 0 && column > 0)
        sentence = tr("Line %1, column %2: %3").arg(line).arg(column).arg(sentence);
    else if (line > 0)
        sentence = tr("Line %1: %2").arg(line).arg(sentence);
    auto *text = new QLabel(sentence, row);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    layout->addWidget(icon);
    layout->addWidget(text, 1);
    if (const int at = m_raw.rowOf(line); at >= 0)
        connect(addLink(*layout, tr("go to the line"), sentence), &QPushButton::clicked, this, [this, at] {
            m_rawView->setCurrentIndex(m_raw.index(at));
            m_rawView->scrollTo(m_raw.index(at));
        });
    m_remarks->addWidget(row);
    return layout;
}

void ImportAssistant::addQuestion(const Question &question) {
    const QString sentence = windowLanguage().sentence(question.sentence);
    QHBoxLayout *row =
        addRow(question.grade == QuestionGrade::red ? RemarkGrade::problem : RemarkGrade::assumption,
               sentence, question.line, question.column, question.further.size() + 1);
    const auto choice = std::ranges::find(m_imported.choices, question.id, &ImportChoice::key);
    if (choice == m_imported.choices.end() || choice->origin != Origin::guessed)
        return;
    QPushButton *button = addLink(*row, tr("confirm"), sentence);
    button->setObjectName(QStringLiteral("confirm.") + QString::fromStdString(question.id));
    connect(button, &QPushButton::clicked, this, [this, key = question.id] { confirm(key); });
}

void ImportAssistant::addRemark(const Remark &remark) {
    const QString sentence = windowLanguage().sentence(remark.message);
    QHBoxLayout *row = addRow(remark.grade, sentence, remark.line, remark.column, remark.times);
    const auto choice = std::ranges::find(m_imported.choices, remark.choice, &ImportChoice::key);
    if (remark.choice.empty() || choice == m_imported.choices.end() || choice->origin != Origin::guessed)
        return;
    QPushButton *button = addLink(*row, tr("confirm"), sentence);
    button->setObjectName(QStringLiteral("confirm.") + QString::fromStdString(remark.choice));
    connect(button, &QPushButton::clicked, this, [this, key = remark.choice] { confirm(key); });
}

void ImportAssistant::showRemarks() {
    while (QLayoutItem *item = m_remarks->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater();
        }
        delete item;
    }
    if (m_refusal) {
        auto *reason = new QLabel(*m_refusal);
        reason->setObjectName(QStringLiteral("importRefusal"));
        reason->setProperty("reason", true);
        reason->setTextFormat(Qt::PlainText);
        reason->setWordWrap(true);
        m_remarks->addWidget(reason);
    }
    for (const Question &question : m_imported.questions)
        addQuestion(question);
    for (std::size_t i = 0; i < std::min(m_imported.remarks.size(), remarksShown); ++i)
        addRemark(m_imported.remarks[i]);
    if (m_imported.remarks.size() > remarksShown)
        m_remarks->addWidget(new QLabel(tr("… and %n more remark(s)", nullptr,
                                           static_cast<int>(m_imported.remarks.size() - remarksShown))));
    m_remarks->addStretch();
}

void ImportAssistant::showCurve() {
    m_curve.reset();
    m_noCurve->setText(tr("There is no curve of this measurement."));
    m_curves->setCurrentWidget(m_noCurve);
    if (!m_imported.test) {
        const LineFigure temperatures = temperatureFigure(m_imported.sensors, windowLanguage());
        m_lineView->setFigure(temperatures);
        if (!temperatures.lines.empty())
            m_curves->setCurrentWidget(m_lineView);
        return;
    }
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(*m_imported.test));
    const EvaluatedDocument evaluated = evaluate(document);
    const Test &test = *document->tests[0];
    if (std::holds_alternative<PositioningMeasurement>(test.measurement)) {
        DeviationFigureOptions options;
        options.dimensions = false; // results are not looked at before the readings are right
        m_curve = deviationFigure(test, *evaluated.tests[0], windowLanguage(), options);
        m_curveCanvas->setFigure(*m_curve, {});
        m_curves->setCurrentWidget(m_curveCanvas);
    } else if (std::holds_alternative<CircularMeasurement>(test.measurement)) {
        m_circleCanvas->show(evaluated, 0, {}, windowLanguage());
        m_curves->setCurrentWidget(m_circleCanvas);
    } else {
        m_curve = driftFigure(test, *evaluated.tests[0], windowLanguage());
        m_curveCanvas->setFigure(*m_curve, {});
        m_curves->setCurrentWidget(m_curveCanvas);
    }
}

void ImportAssistant::showSizes() {
    m_rawSize->setText(tr("%n line(s)", nullptr, m_raw.rowCount()));
    QStringList sizes;
    if (m_imported.test) {
        const auto &measurement = m_imported.test->measurement;
        if (const auto *positioning = std::get_if<PositioningMeasurement>(&measurement)) {
            sizes << tr("%n target(s)", nullptr, static_cast<int>(positioning->targets.size()));
            for (const auto &[approach, arrow] :
                 {std::pair(Direction::positive, u'↑'), std::pair(Direction::negative, u'↓')}) {
                const auto runs = std::ranges::count(positioning->runs, approach, &Run::approach);
                sizes << tr("%n run(s)", nullptr, static_cast<int>(runs)) + u' ' + arrow;
            }
        } else if (const auto *circular = std::get_if<CircularMeasurement>(&measurement)) {
            sizes << tr("%n arc(s)", nullptr, static_cast<int>(circular->arcs.size()))
                  << tr("%n point(s)", nullptr, readingsOf(m_imported));
        } else {
            sizes << tr("%n point(s)", nullptr, readingsOf(m_imported));
        }
    } else {
        sizes << tr("%n sensor(s)", nullptr, static_cast<int>(m_imported.sensors.size()));
    }
    m_tableSize->setText(sizes.join(QStringLiteral(" · ")));
}

void ImportAssistant::refresh() {
    m_raw.show(&m_imported);
    m_recognised.show(&m_imported);
    showSizes();
    showChoices();
    showRemarks();
    showCurve();
    const int readings = readingsOf(m_imported);
    m_import->setText(tr("&Import %n reading(s)", nullptr, readings));
    m_import->setEnabled(!m_refusal && readings > 0);
    const auto guesses = std::ranges::count(m_imported.choices, Origin::guessed, &ImportChoice::origin);
    const int missing = missingOf(m_imported);
    QStringList open;
    if (missing > 0)
        open << tr("%n missing reading(s)", nullptr, missing);
    if (guesses > 0)
        open << tr("%n assumption(s)", nullptr, static_cast<int>(guesses));
    m_open->setText(open.join(QStringLiteral(" · ")));
    m_open->setStyleSheet(QStringLiteral("color: %1;").arg(token(Token::unsure, palette()).name()));
}

/// What still is in a field was meant, too: a mnemonic does not leave the field.
void ImportAssistant::takeTyped() {
    for (const Box &box : m_boxes) {
        if (box.edit && box.edit->isModified()) {
            choose(box.key, box.edit->text().trimmed().toStdString());
            return; // one at most: others were left; and the boxes may be others now
        }
    }
}

void ImportAssistant::accept() {
    takeTyped();
    if (!m_import->isEnabled())
        return;
    try {
        Document trial = wantsNewDocument() ? Document() : *m_document;
        addTo(trial);
    } catch (const Error &error) {
        refuse(error, {});
        showRemarks();
        return;
    }
    QSettings settings;
    settings.setValue(QStringLiteral("import/keepBytes"), m_keep->isChecked());
    settings.setValue(profileSetting(m_fileName),
                      m_profile->currentIndex() > 0 ? m_profile->currentText() : QString());
    QDialog::accept();
}

void ImportAssistant::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void ImportAssistant::retranslate() {
    setWindowTitle(tr("Import"));
    m_other->setText(tr("&Other file…"));
    m_paste->setText(tr("&Paste text"));
    m_title->setText(tr("Import %1").arg(m_fileName));
    const QString hash = QString::fromStdString(sha256(m_bytes));
    m_origin->setText(QStringLiteral("%1 · SHA-256 %2…%3")
                          .arg(QLocale().formattedDataSize(m_bytes.size(), 1), hash.left(4), hash.right(4)));
    m_origin->setToolTip(hash);
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
    m_remarksTitle->setText(tr("Remarks, to be read before the import"));
    m_keep->setText(tr("&Keep the original in the file"));
    m_saveProfile->setText(tr("&Save these choices as a profile…"));
    m_cancel->setText(tr("&Cancel"));
    makeBoxes(); // in the language, and with it
    refresh();
}

} // namespace palmer::ui
