// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"
#include "ui/qtforward.h"

#include <map>

namespace palmer::ui {

/// The conditions of a test: temperatures, cycle, positions, the axis and its targets.
class ConditionsPage : public Form {
    Q_OBJECT

public:
    ConditionsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    /// As Form; for the instruments focuses the first checkbox.
    bool focusField(const QString &id) override;

protected:
    void prepare() override;
    void refreshOthers() override;

private:
    void addTemperatures(const Conditions &conditions);
    void addCorrection();
    void addSensorButtons();
    template <class Measurement>
    void addFields(const Measurement &measurement);
    // Statements specific to a kind of test.
    void addAir(const PositioningMeasurement &measurement);
    void addAir(const CircularMeasurement & /*measurement*/) {}
    void addCycle(const PositioningMeasurement &measurement);
    void addCycle(const CircularMeasurement &measurement);
    void addAgreedCycle(const PositioningMeasurement &measurement);
    void addAgreedCycle(const CircularMeasurement &measurement);
    void addPlace(const PositioningMeasurement & /*measurement*/) {}
    void addPlace(const CircularMeasurement &measurement);
    void addAxis(const PositioningMeasurement &measurement);
    void addAxis(const CircularMeasurement &measurement);
    void addSensor(SensorMeasures what, std::size_t ordinal);
    void addWarmUp();
    void addSpecifiedBy(int width);
    /// Requirements met only by declarations, by clause of the edition, with a button to answer the rest with
    /// yes.
    void addDeclarations(const Edition *edition);
    void addDeclarationsOf(const Edition *edition, const std::string &clause);
    [[nodiscard]] QString temperatureSummary() const;
    [[nodiscard]] QString declarationSummary() const;
    void addPositions();
    void addTestAndPurpose();
    void addTargets(const PositioningMeasurement &measurement);
    void addInstruments();

    QString m_built; ///< the kind of test the fields were built for
    std::vector<QCheckBox *> m_instruments;
    QLabel *m_correction = nullptr;                  ///< size of the correction to 20 °C
    std::map<SensorMeasures, Field *> m_lastSensors; ///< the first field of the last sensor of each kind
};

} // namespace palmer::ui
