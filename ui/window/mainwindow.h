// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "document/recovery.h"
#include "ui/model/autosave.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/model/evaluator.h"
#include "ui/model/filewatch.h"

#include "kernel/evaluation/edition.h"

#include <QLockFile>
#include <QMainWindow>
#include <QPointer>
#include <memory>
#include <optional>

class QLabel;
class QMenu;
class QStackedWidget;
class QToolBar;

namespace palmer::ui {

class HelpWindow;
class ImportAssistant;
class NoticeBar;
class ReportBar;
class WelcomePage;
class Workplace;
struct OpenedReport;

/// One window, one file. Builds the parts and connects them; computes nothing.
class MainWindow : public QMainWindow {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(MainWindow)

public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Opens a test file: here when nothing is open, else in another window; a file that is open already is
    /// brought to the front. What cannot be opened is said in one sentence, and nothing changes.
    /// A report (PDF) opens as a copy of the test file inside it, with a bar that says whether it follows.
    /// A file that is no test file is a measurement: it goes to the import assistant, several one after the
    /// other. `test`: of a test file the one that is brought into view, from 0; null: the first of a file
    /// that was not open.
    void openFile(const QString &path, std::optional<std::size_t> test = std::nullopt);

    /// Shows measurement files in the import assistant, one after the other; what is accepted goes into the
    /// open document as one step to undo, or makes a new one. A file that cannot be read is refused with one
    /// sentence.
    void importFiles(const QStringList &paths);
    /// The same for the text on the clipboard, as a spreadsheet puts it there.
    void importClipboard();

    /// Saves under that path; false, and a message, when that fails.
    bool saveTo(const QString &path);

    /// Opens what was found after a crash, with unsaved changes; its copy goes when this window has one.
    void openRecovery(const Recovery &recovery);
    /// Asks what becomes of copies that a crash has left; nothing where there are none.
    void offerRecoveries();

    /// Puts what is not saved into a copy at once, before the program is ended from outside.
    void keepCopy();

    [[nodiscard]] Autosave &autosave() { return m_autosave; }
    [[nodiscard]] DocumentModel &model() { return m_model; }
    [[nodiscard]] Evaluator &evaluator() { return m_evaluator; }
    [[nodiscard]] Workplace &workplace() { return *m_workplace; }
    /// Whether a document is open, and not the welcome page.
    [[nodiscard]] bool hasDocument() const;

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QAction *addAction(QMenu *menu, const QString &name, const QString &icon = {});
    void makeActions();
    void makeToolBar();
    void makeStatusBar();
    void connectParts();

    void chooseFile();
    void chooseMeasurements();
    void importNext();
    void showAssistant(const QByteArray &bytes, const QString &fileName);
    void takeImport(const ImportAssistant &assistant);
    bool save();
    bool saveAs();
    bool mayClose();
    /// Whether closing would lose something: changes, or a file that is on no disk as it is here.
    [[nodiscard]] bool isUnsaved() const;
    /// Takes the file as it is, or as it was, for what this document was read from.
    void watchFile(const std::optional<FileState> &known = {});
    /// Marks the file as open here for other programs and other machines, and says where it is open already.
    void lockFile();
    /// Neither the program nor anybody may write to the file, or to its folder.
    [[nodiscard]] bool isReadOnly() const;
    bool mayForget(const QStringList &refused);
    [[nodiscard]] static QString notTaken(const QStringList &refused);
    void read(const QString &path, std::optional<std::size_t> test);
    /// Opens what a report was made from, and verifies the report.
    MainWindow *takeReport(const OpenedReport &report, const QString &path);
    MainWindow *take(Document document, const QString &path, bool modified = false,
                     const QString &reportPath = {});
    /// `ofThisFile`: the statements of the test in view may be taken over.
    [[nodiscard]] std::optional<Test> askForTest(Kind kind, bool ofThisFile);
    void newFile(Kind kind);
    void addTest(Kind kind);
    void addDriftTest();
    void renameTest();
    void duplicateTest(bool withReadings);
    void deleteTest();
    [[nodiscard]] const Test *currentTest() const;
    void fileChangedOutside();
    void reload();
    void showError(const QString &title, const QString &fileName, const Error &error);
    /// Undoes or redoes a step and brings what it changed into view.
    void step(bool forward);
    static void quit();
    void fillRecentMenu();
    void fillExamplesMenu();
    void showState();
    void remember();
    void setEdition(std::size_t test, const QString &edition);
    void showReport();
    void showPlan();
    void showComparison();
    void showCompensation();
    void showHelp();
    void showFeed();
    void showHelpPage(const QString &id, const QString &anchor = {});
    void showShortcuts();
    void showSettings();
    void about();
    void retranslate();

    DocumentModel m_model;
    Evaluator m_evaluator;
    Autosave m_autosave{m_model};
    FileWatch m_watch;
    std::unique_ptr<QLockFile> m_lock; ///< beside the file; null where there is none, or another has it
    QStringList m_reading;             ///< files being read
    Background m_reader;
    QString m_reportPath; ///< of the report that the document was opened from; empty: it was not
    bool m_open = false;
    bool m_rememberNext = false;
    QStringList m_toImport; ///< measurement files that wait for the assistant
    QPointer<ImportAssistant> m_assistant;
    QString m_savedAt;
    QPointer<HelpWindow> m_help;
    QString m_autosavedAt;
    bool m_discarded = false;    ///< the user said that all changes may go
    bool m_outsideAsked = false; ///< the user knows that the file is another
    bool m_fileGone = false;     ///< the file is no longer there

    QWidget *m_centre; ///< made first: whatever moves to another parent costs all styles below it anew
    NoticeBar *m_notice;
    ReportBar *m_reportBar;
    QStackedWidget *m_stack;
    WelcomePage *m_welcome;
    Workplace *m_workplace;
    QToolBar *m_toolBar;
    QMenu *m_fileMenu;
    QMenu *m_recentMenu;
    QMenu *m_examplesMenu;
    QMenu *m_exportMenu;
    QMenu *m_editMenu;
    QMenu *m_testMenu;
    QMenu *m_viewMenu;
    QMenu *m_toolsMenu;
    QMenu *m_unitsMenu;
    QMenu *m_helpMenu;
    QLabel *m_content;
    QLabel *m_hint;
    QLabel *m_state;

    QAction *m_newAction;
    QAction *m_newCircleAction;
    QAction *m_openAction;
    QAction *m_importAction;
    QAction *m_importClipboardAction;
    QAction *m_saveAction;
    QAction *m_saveAsAction;
    QAction *m_reportAction;
    QAction *m_planAction;
    QAction *m_compareAction;
    QAction *m_exportReadingsAction;
    QAction *m_exportFigureAction;
    QAction *m_compensationAction;
    QAction *m_newWindowAction;
    QAction *m_closeAction;
    QAction *m_quitAction;
    QAction *m_undoAction;
    QAction *m_redoAction;
    QAction *m_addTestAction;
    QAction *m_addCircleAction;
    QAction *m_addDriftAction;
    QAction *m_renameTestAction;
    QAction *m_duplicateTestAction;
    QAction *m_repeatTestAction;
    QAction *m_deleteTestAction;
    QAction *m_previousTestAction;
    QAction *m_nextTestAction;
    QAction *m_setEditionAction;
    QAction *m_ownEditionAction;
    QAction *m_feedAction;
    QAction *m_registerAction = nullptr;
    std::array<QAction *, 6> m_pageActions{};
    QAction *m_nextMissingAction;
    QAction *m_previousMissingAction;
    QAction *m_nextPaneAction;
    QAction *m_previousPaneAction;
    QAction *m_maximiseAction;
    std::array<QAction *, 3> m_lengthActions{};
    std::array<QAction *, 2> m_angleActions{};
    QAction *m_frenchAction;
    QAction *m_englishAction;
    QAction *m_helpAction;
    QAction *m_shortcutsAction;
    QAction *m_validationAction;
    QAction *m_settingsAction;
    QAction *m_aboutAction;
    QAction *m_aboutQtAction;
};

} // namespace palmer::ui
