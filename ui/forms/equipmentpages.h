// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"

#include <array>

namespace palmer::ui {

/// The measuring instruments of the file and their traceability.
class InstrumentsPage : public Form {
    Q_OBJECT

public:
    InstrumentsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

protected:
    void prepare() override;
    void refreshOthers() override;

private:
    void addFields(std::size_t k);

    DocumentModel &m_documents;
    Selection &m_selection;
    QString m_built;                     ///< the instruments the fields were built for
    std::vector<Quantity> m_resolutions; ///< per instrument: a length or an angle
    std::vector<Field *> m_descriptions; ///< the first field per instrument
    /// Per instrument: laboratory, accreditation and certificate of its calibration.
    std::vector<std::array<Field *, 3>> m_traces;
};

/// The machine under test.
class MachinePage : public Form {
    Q_OBJECT

public:
    MachinePage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);
};

} // namespace palmer::ui
