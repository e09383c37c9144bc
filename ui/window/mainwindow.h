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

class QLabel;
class QMenu;
class QScrollArea;
class QStackedWidget;
class QToolBar;
class QToolButton;

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
class WelcomePage;
class Workplace;

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
    Workplace &workplace();
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
    [[nodiscard]] std::size_t testInView() const;
    void fileChangedOutside();
    void reload();
    void showError(const QString &title, const QString &fileName, const Error &error);
    /// Undoes or redoes a step and brings what it changed into view.
    void step(bool forward);
    static void quit();
    void fillRecentMenu();
    void fillExamplesMenu();
    void showUndo();
    void enableActions();
    [[nodiscard]] bool hasTools() const; ///< whether there is something for them, and room
    void showState();
    void remember();
    void setEdition(std::size_t test, const QString &edition);
    [[nodiscard]] QString editionInView() const; ///< the word of the edition that the results are of
    void showPageOf(Page page);
    void exportReadings();
    void exportFigure();
    void showReport();
    void showPlan();
    void showComparison();
    void showCompensation();
    void showHelp();
    void showFeed();
    void showHelpPage(const QString &id, const QString &anchor = {});
    void showShortcuts();
    void showSettings();
    void retranslate();

    DocumentModel m_model;
    Evaluator m_evaluator;
    Autosave m_autosave{m_model};
    FileWatch m_watch;
    FileLock m_lock;
    QStringList m_reading; ///< files being read
    std::shared_ptr<ReadProgress> m_progress = std::make_shared<ReadProgress>();
    Background m_reader;
    DocumentPointer m_verified; ///< what a report that was opened holds; null: none was
    QString m_reportPath;       ///< of the report that the document was opened from; empty: it was not
    bool m_open = false;
    bool m_rememberNext = false;
    QStringList m_toImport; ///< measurement files that wait for the assistant
    QString m_importing;    ///< the one that is being read for it; empty: none
    QPointer<ImportAssistant> m_assistant;
    QString m_savedAt;
    QPointer<HelpWindow> m_help;
    QString m_autosavedAt;
    bool m_discarded = false;    ///< the user said that all changes may go
    bool m_outsideAsked = false; ///< the user knows that the file is another
    bool m_fileGone = false;     ///< the file is no longer there

    /// Made first: whatever moves to another parent costs all styles below it anew.
    QWidget *m_centre = nullptr;
    NoticeBar *m_notice = nullptr;
    ReportBar *m_reportBar = nullptr;
    WorkBar *m_work = nullptr;
    QStackedWidget *m_stack = nullptr;
    WelcomePage *m_welcome = nullptr;
    QScrollArea *m_place = nullptr; ///< of the workplace
    Workplace *m_workplace = nullptr;
    QToolBar *m_toolBar = nullptr;
    QLabel *m_content = nullptr;
    QLabel *m_hint = nullptr;
    QLabel *m_state = nullptr;
    std::array<QMenu *, windowMenus> m_menus{};
    std::array<QAction *, windowActions> m_actions{};
};

} // namespace palmer::ui
