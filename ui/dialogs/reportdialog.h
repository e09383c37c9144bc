// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "document/savefiles.h"
#include "print/pdf/pages.h"
#include "report/attachedfile.h"
#include "report/blocks/report.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/model/evaluator.h"
#include "ui/model/simulator.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <functional>
#include <vector>

namespace palmer::ui {

class PageColumn;

/// "Report…": the pages to print and, next to them, the choices for the report: languages, paper, sections,
/// signatures. These belong to the document; choosing them edits it. Saves a PDF in each language, prints.
/// Pages are composed and files written in the background: meanwhile the first page can be read, the number
/// of pages is a dash, and what needs all pages is disabled. Over 500 lines: each choice is a row that
/// edits, composes anew and is restored.
class ReportDialog : public Translated<QDialog> {
    Q_OBJECT

public:
    ReportDialog(DocumentModel &model, Evaluator &evaluator, QWidget *parent = nullptr);

    /// Shows the part with that anchor once its page is composed; the first page if there is none.
    void beginAt(const QString &anchor) { m_anchor = anchor; }

    /// Notes something that the report does not have, above what is missing.
    void setNote(const QString &note) { m_note = note; }

    /// Writes a PDF, or NAME.fr.pdf and NAME.en.pdf for two languages; requires composed pages. Emits
    /// saved() at the end; on failure shows a message first.
    void saveTo(const QString &path);
    /// Prints the pages as shown.
    bool printOn(QPrinter &printer);

    [[nodiscard]] int pageCount() const;
    /// True while pages of the latest document are being composed.
    [[nodiscard]] bool isComposing() const { return m_composer.isBusy(); }
    /// True while a simulation needed for the pages is running, or pages with its results are composed.
    [[nodiscard]] bool isSimulating() const { return m_simulator.isRunning() || isComposing(); }

signals:
    /// The files written; none if one could not be.
    void saved(const QStringList &files);

public slots:
    void reject() override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    /// A checkbox for a value in a list of the report head.
    struct Choice {
        QCheckBox *box = nullptr;
        const char *text = nullptr;
        std::function<bool(const ReportHead &)> isOn;
        std::function<void(ReportHead &, bool)> set;
    };

    /// The sources of the pages.
    struct Source {
        std::shared_ptr<const Document> document;
        std::vector<TestEvaluationPointer> results; ///< from which the evaluation starts
        Originals originals = Originals::leaveOut;

        bool operator==(const Source &) const = default;
    };
    struct Composed {
        Source source; ///< with the results of the evaluation
        EvaluatedDocument evaluated;
        std::vector<Report> reports;
        Pages pages;
        std::optional<Message> refused = {};
    };
    struct Written {
        QStringList files;
        QString refused = {}; ///< the file that could not be written
        Message why = {};
    };

    QWidget *makeHead();
    QWidget *makeSide();
    void makeLanguages(QVBoxLayout &column);
    void makeSimulation(QVBoxLayout &whole);
    void makeNotes(QVBoxLayout &whole);
    void makeButtons(QVBoxLayout &whole);
    void addChoices(QVBoxLayout *column);
    void compose();
    [[nodiscard]] std::shared_ptr<const Composed>
    composed(const Background::Job &job, Source source, const EvaluatedDocument &previous, bool showsFirst);
    void keep(const std::shared_ptr<const Composed> &composed);
    void take(std::shared_ptr<const Composed> composed);
    void showEvaluated(EvaluatedDocument evaluated);
    void showPages(Pages pages);
    void showDocument();
    void showLength();
    void showProgress();
    void change(const std::function<void(ReportHead &)> &change);
    void goTo(int page);
    void goToAnchor();
    void followScroll();
    void setScale(double scale);
    void fitWidth();
    void choosePdf();
    /// The files written when saving to that path.
    [[nodiscard]] QStringList filesOf(const QString &path) const;
    void take(const Written &written);
    /// Asks before replacing existing files.
    [[nodiscard]] bool mayReplace(const QStringList &files);
    void showSaved(const QStringList &files);
    void choosePrinter();
    void retranslate() final;

    DocumentModel &m_model;
    Evaluator &m_evaluator;
    Simulator m_simulator;
    std::shared_ptr<const Document> m_simulated; ///< last simulated, or cancelled: not started again
    EvaluatedDocument m_evaluated;
    Source m_source; ///< of the pages that are shown or being composed
    std::shared_ptr<const Composed> m_composed = std::make_shared<Composed>();
    /// Composed before, the last one last: shown again at once if choices are taken back. For the composing
    /// thread alone.
    std::vector<std::shared_ptr<const Composed>> m_kept;
    Pages m_pages;
    bool m_fit = true;
    QString m_anchor; ///< still to be shown

    QLabel *m_title = nullptr;
    QLabel *m_summary = nullptr;
    QPushButton *m_open = nullptr; ///< opens the last saved file
    QPushButton *m_openFolder = nullptr;
    QStringList m_saved;
    QToolButton *m_previous = nullptr;
    QLabel *m_place = nullptr;
    QToolButton *m_next = nullptr;
    QToolButton *m_smaller = nullptr;
    QLabel *m_zoom = nullptr;
    QToolButton *m_larger = nullptr;
    QPushButton *m_width = nullptr;
    PageColumn *m_small = nullptr;
    PageColumn *m_column = nullptr;
    QScrollArea *m_smallArea = nullptr;
    QScrollArea *m_area = nullptr;
    QLabel *m_languageTitle = nullptr;
    QButtonGroup *m_languages = nullptr;
    QToolButton *m_both = nullptr;
    QLabel *m_paperTitle = nullptr;
    QComboBox *m_paper = nullptr;
    QLabel *m_sectionsTitle = nullptr;
    QLabel *m_signaturesTitle = nullptr;
    std::vector<Choice> m_choices;
    QWidget *m_simulation = nullptr;
    QLabel *m_simulationText = nullptr;
    QProgressBar *m_simulationBar = nullptr;
    QPushButton *m_simulationCancel = nullptr;
    QCheckBox *m_allReadings = nullptr;
    QCheckBox *m_originals = nullptr;
    QCheckBox *m_certificate = nullptr;
    QLabel *m_attached = nullptr;
    QLabel *m_missing = nullptr;
    QString m_note;
    QPushButton *m_save = nullptr;
    QPushButton *m_print = nullptr;
    QPushButton *m_close = nullptr;
    Background m_writer;
    Background m_composer; ///< last: its jobs use the others
};

} // namespace palmer::ui
