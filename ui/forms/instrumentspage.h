#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// The measuring instruments of the file and their traceability.
class InstrumentsPage : public Form {
    Q_OBJECT

public:
    explicit InstrumentsPage(QWidget *parent = nullptr);

protected:
    void prepare() override;

private:
    std::size_t m_built = 0; ///< instruments that have fields
};

} // namespace palmer::ui
