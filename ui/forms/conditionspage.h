// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/conditionsform.h"
#include "ui/forms/form.h"
#include "ui/qtforward.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace palmer::ui {

class ElidedLabel;

/// The conditions of a test: what its edition asks for in one grid, what is usual or free folded below it.
/// Over 500 lines with the sensors of the temperatures, a list within the grid.
class ConditionsPage : public Form {
    Q_OBJECT

public:
    ConditionsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    /// As Form; for the instruments focuses the first checkbox.
    bool focusField(const QString &id) override;

signals:
    /// Fills the test like the last one of the machine.
    void likeLastWanted();

protected:
    void prepare() override;
    void refreshOthers() override;
    [[nodiscard]] QString missingText(int count) const override;
    void showEvent(QShowEvent *event) override;

private:
    void order(std::vector<FormGroup> &groups);
    void addGroups(const std::vector<FormGroup> &groups);
    void addCell(const FormCell &cell);
    void addTemperatures(const Conditions &conditions);
    void addSensor(SensorMeasures what, std::size_t ordinal, bool first);
    void addAllApply(int columns);
    void addInstruments();

    struct SensorName {
        QLabel *name = nullptr;
        SensorMeasures what = SensorMeasures::notStated;
        QString argument; ///< number of a further sensor
    };
    [[nodiscard]] static QString nameOf(const SensorName &sensor);

    QString m_built;               ///< what the fields were built for
    std::set<std::string> m_first; ///< groups that come first, by name
    QString m_ordered;             ///< test and edition they were found for
    bool m_isOrderDue = true;      ///< the page came into view
    std::vector<QCheckBox *> m_instruments;
    std::vector<SensorName> m_sensorNames;
    std::map<std::string, Field *> m_clauses; ///< declarations by key, each with its clause
    QPushButton *m_like = nullptr;
    ElidedLabel *m_correction = nullptr; ///< size of the correction to 20 °C
    Field *m_start = nullptr;            ///< heads of the columns of temperatures
    Field *m_end = nullptr;
    QLabel *m_expansion = nullptr;
    std::map<SensorMeasures, Field *> m_lastSensors; ///< the first field of the last sensor of each kind
};

} // namespace palmer::ui
