// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "document/readprogress.h"
#include "document/recovery.h"
#include "ui/model/autosave.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/model/evaluator.h"
#include "ui/model/filewatch.h"
#include "ui/model/page.h"
#include "ui/qtforward.h"
#include "ui/translated.h"
#include "ui/window/filelock.h"
#include "ui/window/windowaction.h"

#include "kernel/evaluation/edition.h"

#include <QMainWindow>
#include <QPointer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace palmer {

struct OpenedReport;

} // namespace palmer

namespace palmer::ui {

class HelpWindow;
class ImportAssistant;
class WorkBar;
struct MeasurementFile;
class NoticeBar;
class ReportBar;
class SearchBox;
struct SearchEntry;
class WelcomePage;
class Workplace;

/// A window with one file. Builds and connects the parts; computes nothing. Over 500 lines: every action
/// ends here in a function of a few lines; what has a state of its own (workplace, bars, dialogs, jobs) is
/// a class of its own.
class MainWindow : public Translated<QMainWindow> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(MainWindow)

public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Opens a test file, in this window if nothing is open, otherwise in another one; a file already open is
    /// brought to the front. A failure is reported in one sentence and changes nothing.
    /// A report (PDF) opens as a copy of the test file inside it, with a bar that shows whether the report
    /// agrees with it.
    /// Any other file is a measurement and goes to the import assistant, several one after another. `test`:
    /// index from 0 of the test to bring into view; null: the first one, if the file was not open.
    void openFile(const QString &path, std::optional<std::size_t> test = std::nullopt);

    /// Shows measurement files in the import assistant, one after another; accepted data go into the open
    /// document as one undo step, or into a new one. A file that cannot be read is refused with one sentence.
    void importFiles(const QStringList &paths);
    /// Imports the text on the clipboard, as copied from a spreadsheet.
    void importClipboard();

    /// Saves under that path; on failure shows a message and returns false.
    bool saveTo(const QString &path);

    /// Opens a recovered document with its unsaved changes; its copy is removed once this window wrote one.
    void openRecovery(const Recovery &recovery);
    /// Asks what to do with the copies left by a crash, if any.
    void offerRecoveries();

    /// Writes unsaved changes to a copy at once, before the program is ended from outside.
    void keepCopy();

    [[nodiscard]] Autosave &autosave() { return m_autosave; }
    [[nodiscard]] DocumentModel &model() { return m_model; }
    [[nodiscard]] Evaluator &evaluator() { return m_evaluator; }
    Workplace &workplace();
    /// True if a document is open, not the welcome page.
    [[nodiscard]] bool hasDocument() const;

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct MenuRow;
    [[nodiscard]] static const std::vector<MenuRow> &menuRows();
    void makeMenus();
    QAction *addAction(QMenu &menu, const MenuRow &row);
    [[nodiscard]] QAction *action(WindowAction which) const;
    [[nodiscard]] QMenu *menu(WindowMenu which) const;
    void nameActions();
    void makeToolBar();
    [[nodiscard]] QToolButton &toolButton(WindowAction tool) const;
    void makeStatusBar();
    void connectParts();

    void chooseFile();
    void chooseMeasurements();
    void importNext();
    void readToImport(const std::function<QByteArray(const std::stop_token &)> &bytes, const QString &name,
                      qint64 size);
    void makePagesMeanwhile();
    void showReading();
    void cancelReading();
    void showAssistant(MeasurementFile file);
    void adoptImport(const ImportAssistant &assistant);
    bool save();
    bool saveAs();
    bool mayClose();
    /// True if closing would lose changes, or a document that no file on disk agrees with.
    [[nodiscard]] bool isUnsaved() const;
    /// Records the state of the file, now or as `known`, as the one this document was read from.
    void watchFile(const std::optional<FileState> &known = {});
    /// Locks the file for other programs and machines, or reports where it is already open.
    void lockFile();
    /// True if the file cannot be written, see mayNotBeWritten().
    [[nodiscard]] bool isReadOnly() const;
    bool mayForget(const QStringList &refused);
    [[nodiscard]] static QString notTaken(const QStringList &refused);
    void read(const QString &path, std::optional<std::size_t> test);
    /// Opens the test file inside a report and verifies the report.
    MainWindow *adoptReport(const OpenedReport &report, const QString &path);
    /// Says whether a printed history follows from the data in it: it has no test file to show.
    void showVerified(const OpenedReport &history, const QString &path);
    MainWindow *adopt(Document document, const QString &path, bool modified = false,
                      const QString &reportPath = {});
    /// `ofThisFile`: the statements of the test in view may be copied.
    [[nodiscard]] std::optional<Test> askForTest(Kind kind, bool ofThisFile);
    void newFile(Kind kind);
    void addTest(Kind kind);
    void addDriftTest();
    void renameTest();
    void duplicateTest();
    void repeatTest();
    void askName(const QString &title, const QString &name,
                 const std::function<void(const std::string &)> &take);
    void deleteTest();
    [[nodiscard]] const Test *currentTest() const;
    [[nodiscard]] std::size_t testInView() const;
    void fileChangedOutside();
    void reload();
    void showError(const QString &title, const QString &fileName, const Error &error);
    /// Undoes or redoes a step and brings its change into view.
    void step(bool forward);
    void goToStep(int index);
    static void quit();
    void fillRecentMenu();
    void fillExamplesMenu();
    void fillHistoryMenu();
    void showUndo();
    void enableActions();
    [[nodiscard]] bool hasTools() const; ///< true if there are tools to show and room for them
    void showState();
    void remember();
    void setEdition(std::size_t test, const QString &edition);
    [[nodiscard]] QString editionInView() const; ///< word of the edition that the results are based on
    void showPageOf(Page page);
    void exportReadings();
    void exportFigure();
    /// `anchor`: of the part to begin with; empty: the first page.
    void showReport(const QString &anchor = {});
    void fillLikeLast();
    [[nodiscard]] std::vector<SearchEntry> searchEntries();
    static void changeTextSize(int steps);
    void showPlan();
    void showComparison();
    void showCompensation();
    void showHelp();
    void showFeed();
    void showHelpPage(const QString &id, const QString &anchor = {});
    void showShortcuts();
    void showSettings();
    void retranslate() final;

    DocumentModel m_model;
    Evaluator m_evaluator;
    Autosave m_autosave{m_model};
    FileWatch m_watch;
    FileLock m_lock;
    QStringList m_reading; ///< files being read
    std::shared_ptr<ReadProgress> m_progress = std::make_shared<ReadProgress>();
    Background m_reader;
    Background m_typeReader;    ///< of the example of a type test
    DocumentPointer m_verified; ///< the document in an opened report; null if none was opened
    QString m_reportPath;       ///< report that the document was opened from; empty if none
    bool m_open = false;
    bool m_rememberNext = false;
    QStringList m_toImport; ///< measurement files waiting for the assistant
    QString m_importing;    ///< the file being read for the assistant; empty if none
    QPointer<ImportAssistant> m_assistant;
    QString m_savedAt;
    QPointer<HelpWindow> m_help;
    QString m_autosavedAt;
    bool m_discarded = false;    ///< the user agreed to discard all changes
    bool m_outsideAsked = false; ///< the user knows that the file has changed
    bool m_fileGone = false;     ///< the file no longer exists

    /// Made first: reparenting a widget recomputes all styles below it.
    QWidget *m_centre = nullptr;
    NoticeBar *m_notice = nullptr;
    ReportBar *m_reportBar = nullptr;
    WorkBar *m_work = nullptr;
    QStackedWidget *m_stack = nullptr;
    WelcomePage *m_welcome = nullptr;
    QScrollArea *m_place = nullptr; ///< holds the workplace
    Workplace *m_workplace = nullptr;
    QToolBar *m_toolBar = nullptr;
    SearchBox *m_search = nullptr;
    QLabel *m_content = nullptr;
    QPushButton *m_lack = nullptr; ///< what is missing; leads to the findings
    QLabel *m_hint = nullptr;
    QLabel *m_state = nullptr;
    std::array<QMenu *, windowMenus> m_menus{};
    std::array<QAction *, windowActions> m_actions{};
};

} // namespace palmer::ui
