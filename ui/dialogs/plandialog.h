// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/plannedtest.h"
#include "export/partprogram.h"
#include "kernel/planning/targetplan.h"
#include "report/blocks/report.h"
#include "ui/forms/field.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <functional>
#include <vector>

namespace palmer::ui {

class CycleView;
class DocumentModel;

/// "Plan…": the targets of a positioning test with a diagram of its measuring cycle, printed with an empty
/// table or written as a part program. A test without targets, or a user who asks for new ones, gets
/// targets chosen by the rule of an edition; they go into the test or a new one. Over 500 lines: its
/// diagram, table and program show one plan.
class PlanDialog : public Translated<QDialog> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PlanDialog)

public:
    /// Starts with the statements of the test at that index if it is a positioning test.
    PlanDialog(DocumentModel &model, std::size_t test, QWidget *parent = nullptr);
    /// Hides first, so that a focused field commits its text while the dialog still exists.
    ~PlanDialog() override { hide(); }

    [[nodiscard]] const TargetPlan &plan() const { return m_plan; }
    [[nodiscard]] const CycleProgram &program() const { return m_program; }

    /// Writes the part program in the chosen dialect, for a long axis also that of its zone; on failure shows
    /// a message and returns false.
    bool saveProgram(const QString &path);
    /// Writes the plan as a PDF; on failure shows a message and returns false.
    bool savePlan(const QString &path);
    bool printOn(QPrinter &printer);

signals:
    /// A test was made from the plan; its index.
    void testMade(std::size_t test);

private:
    void makeChoices(QWidget *parent);
    [[nodiscard]] QWidget *makeReseed(QWidget *parent);
    [[nodiscard]] QWidget *makeFields();
    [[nodiscard]] QHBoxLayout *makeButtons();
    /// `set` accepts the number, or returns why not.
    Field *addNumber(const char *name, const char *label, bool whole, std::function<Quantity()> quantity,
                     std::function<std::optional<double>()> get,
                     const std::function<QString(const std::optional<double> &)> &set);
    void begin(std::size_t test);
    void planAnew();
    void replan();
    void showFields();
    void showWhyNoProgram();
    void fillTest();
    void makeTest();
    void choosePlanFile();
    void chooseProgramFile();
    void choosePrinter();
    bool write(const QString &path, const std::function<QByteArray()> &bytes);
    [[nodiscard]] bool canFill() const;
    [[nodiscard]] Report report() const;
    [[nodiscard]] Dialect dialect() const;
    [[nodiscard]] QString summary() const;
    void retranslate() final;

    struct Entry {
        Field *field = nullptr;
        const char *label = nullptr;
        bool whole = false;
        std::function<Quantity()> quantity;
        std::function<std::optional<double>()> get;
        bool ofProgram = false; ///< says how the targets are moved to, not which they are
    };

    DocumentModel &m_model;
    std::size_t m_test;
    TargetRequest m_request;
    std::vector<PlannedMeasurement> m_plans; ///< of the travel and, for a long axis, of its zone
    TargetPlan m_plan;                       ///< of the travel
    CycleProgram m_program;
    std::optional<PlanOfTest> m_own; ///< of the test, as long as no new targets are asked for
    std::optional<int> m_runs;       ///< chosen by the user; null: as the standard requires
    std::string m_edition;

    std::vector<Entry> m_entries;
    Field *m_perMetre = nullptr; ///< linear axes only
    Field *m_axis = nullptr;
    Field *m_motion = nullptr;
    Field *m_rule = nullptr;
    Field *m_cycle = nullptr;
    CycleView *m_view = nullptr;
    QLabel *m_summary = nullptr;
    QLabel *m_overtravel = nullptr;
    QLabel *m_targets = nullptr;
    QPushButton *m_anew = nullptr;
    QPushButton *m_reseed = nullptr;
    QPushButton *m_fill = nullptr;
    QPushButton *m_make = nullptr;
    QPushButton *m_print = nullptr;
    QPushButton *m_savePlan = nullptr;
    QComboBox *m_dialect = nullptr;
    QLabel *m_programReason = nullptr;
    QPushButton *m_saveProgram = nullptr;
    QPushButton *m_close = nullptr;
};

} // namespace palmer::ui
