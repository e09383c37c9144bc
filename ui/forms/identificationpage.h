// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"
#include "ui/qtforward.h"

namespace palmer::ui {

/// The head of the report: number, dates, laboratory with logo, customer, signers.
class IdentificationPage : public Form {
    Q_OBJECT

public:
    IdentificationPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

protected:
    void refreshOthers() override;

private:
    void addLaboratory();
    void addParties();
    void addRemarks();
    using Picture = std::optional<std::string> Laboratory::*;
    struct PictureRow {
        Picture picture = nullptr;
        QLabel *shown = nullptr;
        QPushButton *remove = nullptr;
        std::optional<std::string> drawn; ///< base64 of the displayed picture
        bool isDrawn = false;
    };

    void addPicture(const char *label, const char *choose, const char *remove, Picture picture);
    void choosePicture(Picture picture);
    void addSigners();

    std::vector<PictureRow> m_pictures;
    std::vector<std::pair<Signer, QCheckBox *>> m_signers;
};

} // namespace palmer::ui
