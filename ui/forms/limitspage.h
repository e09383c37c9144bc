#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// The agreed limits of a test and the decision rule. Never beside a verdict.
class LimitsPage : public Form {
    Q_OBJECT

public:
    explicit LimitsPage(Selection &selection, QWidget *parent = nullptr);

protected:
    void prepare() override;

private:
    const Edition *m_built = nullptr; ///< whose parameters have fields
    bool m_rotary = false;
};

} // namespace palmer::ui
