// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/thermal.h"
#include "report/blocks/report.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>
#include <optional>

namespace palmer::ui {

class ElidedBox;
class LineView;
class RowTable;

/// The page "Thermal behaviour" of a drift test: its channels over the temperatures, the response of each to
/// the one that explains most; beside it E_VE over the duration of a test, and what the drift explains of the
/// uncertainty of the test that takes it. Evaluates in the background, while in view.
class ThermalPage : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit ThermalPage(DocumentModel &model, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    /// Makes the widgets next to the page.
    void makeSide(QWidget *parent);
    [[nodiscard]] QWidget *side() const { return m_side; }
    [[nodiscard]] bool isBusy() const { return m_worker.isBusy(); }

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Result {
        std::vector<ThermalChannel> channels;
        DriftCases cases;
        bool angular = false; ///< the test that takes E_VE is of a rotary axis
    };

    void want();
    void fillBoxes();
    void present();
    static void fill(RowTable &table, const Table &content);
    void take();
    void retranslate() final;
    [[nodiscard]] const DriftMeasurement *drift() const;
    [[nodiscard]] std::optional<std::size_t> user() const; ///< the chosen test that takes, or may take, E_VE

    DocumentModel &m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    std::optional<Result> m_result;
    std::vector<std::size_t> m_users;
    Background m_worker;

    QLabel *m_channelLabel;
    ElidedBox *m_channel;
    QLabel *m_userLabel;
    ElidedBox *m_user;
    QPushButton *m_take;
    LineView *m_drift;
    LineView *m_temperatures;
    QLabel *m_responseTitle;
    RowTable *m_responses;
    QLabel *m_notes;
    QWidget *m_side = nullptr;
    QLabel *m_variationTitle = nullptr;
    LineView *m_variation = nullptr;
    QLabel *m_casesTitle = nullptr;
    RowTable *m_cases = nullptr;
};

} // namespace palmer::ui
