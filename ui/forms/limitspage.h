#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// The agreed limits of a test and the decision rule. Never beside a verdict.
class LimitsPage : public Form {
    Q_OBJECT

public:
    LimitsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

protected:
    void prepare() override;

private:
    void addLimit(const std::string &id, const QString &symbol, Quantity quantity, Kind kind);

    QStringList m_built; ///< for which edition and parameters there are fields
};

} // namespace palmer::ui
