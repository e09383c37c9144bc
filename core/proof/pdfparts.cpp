// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/pdfparts.h"

#include "proof/pdffilters.h"

#include <qpdf/Pl_Discard.hh>
#include <qpdf/Pl_String.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFNameTreeObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;

constexpr std::size_t mostPages = 20'000;
constexpr std::size_t mostBookmarks = 100'000;

std::string bytesOf(Handle stream) {
    std::string bytes;
    Pl_String into("stream", nullptr, bytes);
    if (!stream.pipeStreamData(&into, 0, qpdf_dl_specialized))
        throw std::runtime_error("unknown filter");
    return bytes;
}

/// A file embedded in the PDF, however a reader finds it.
struct FoundFile {
    std::string name;
    std::string relationship;
    Handle stream;
    QPDFObjGen id;
};

/// Throws if the names of a specification lead to different files: readers would show one or the other.
std::optional<FoundFile> embeddedFile(Handle specification) {
    if (!specification.isDictionary())
        return {};
    Handle files = specification.getKey("/EF");
    if (!files.isDictionary())
        return {};
    FoundFile result;
    for (const std::string &key : files.getKeys()) {
        Handle stream = files.getKey(key);
        if (!stream.isStream())
            continue;
        if (result.stream.isInitialized() && !(result.id == stream.getObjGen()))
            throw std::runtime_error("names of one file lead to two");
        result.stream = stream;
        result.id = stream.getObjGen();
    }
    if (!result.stream.isInitialized())
        return {};
    for (const char *key : {"/UF", "/F"}) {
        if (result.name.empty() && specification.getKey(key).isString())
            result.name = specification.getKey(key).getUTF8Value();
    }
    if (specification.getKey("/AFRelationship").isName())
        result.relationship = specification.getKey("/AFRelationship").getName();
    return result;
}

std::vector<FoundFile> embeddedFiles(QPDF &document) {
    std::vector<FoundFile> files;
    const auto add = [&files](const Handle &specification) {
        const auto file = embeddedFile(specification);
        const bool isNew = file && std::none_of(files.begin(), files.end(), [&](const FoundFile &other) {
                               return other.id == file->id && other.name == file->name &&
                                      other.relationship == file->relationship;
                           });
        if (isNew)
            files.push_back(*file);
    };
    // Avoids the library's helper, which reports an entry that is no dictionary on stderr and reads on.
    Handle names = document.getRoot().getKey("/Names");
    names = names.isDictionary() ? names.getKey("/EmbeddedFiles") : Handle::newNull();
    if (names.isDictionary()) {
        for (auto &[key, file] : QPDFNameTreeObjectHelper(names, document, false)) {
            if (!file.isDictionary())
                throw std::runtime_error("damaged");
            add(file);
        }
    }
    Handle associated = document.getRoot().getKey("/AF");
    if (associated.isArray()) {
        for (int i = 0; i < associated.getArrayNItems(); ++i)
            add(associated.getArrayItem(i));
    }
    return files;
}

void addUnknownKeys(std::vector<PdfAddition> &additions, Handle dictionary,
                    std::initializer_list<std::string_view> known, int page = 0) {
    if (!dictionary.isDictionary())
        return;
    for (const std::string &key : dictionary.getKeys()) {
        if (std::find(known.begin(), known.end(), std::string_view(key)) == known.end())
            additions.push_back({PdfAddition::Kind::action, page, key.substr(1)});
    }
}

/// Adds everything the file may do besides showing its pages.
void addActions(std::vector<PdfAddition> &additions, QPDF &document) {
    Handle root = document.getRoot();
    addUnknownKeys(additions, root,
                   {"/Type", "/Version", "/Extensions", "/Pages", "/PageLabels", "/Names",
                    "/ViewerPreferences", "/PageLayout", "/PageMode", "/Outlines", "/AcroForm", "/Metadata",
                    "/MarkInfo", "/StructTreeRoot", "/Lang", "/OutputIntents", "/Perms", "/DSS", "/AF"});
    addUnknownKeys(additions, root.getKey("/Names"), {"/EmbeddedFiles"});
    Handle form = root.getKey("/AcroForm");
    addUnknownKeys(additions, form, {"/Fields", "/SigFlags", "/DR", "/DA", "/Q", "/NeedAppearances"});
}

PdfField fieldOf(int page, Handle annotation, double height) {
    const Handle::Rectangle box = annotation.getKey("/Rect").getArrayAsRectangle();
    PdfField field;
    field.page = page;
    field.left = box.llx;
    field.top = height - box.ury;
    field.right = box.urx;
    field.bottom = height - box.lly;
    return field;
}

bool isSignature(const Handle &widget) {
    constexpr int deepest = 8;
    Handle field = widget;
    for (int i = 0; i < deepest && field.isDictionary(); ++i) {
        if (field.getKey("/FT").isName())
            return field.getKey("/FT").getName() == "/Sig";
        field = field.getKey("/Parent");
    }
    return false;
}

/// True for a link of a report, which only leads to another of its pages.
bool isOwnLink(Handle annotation) {
    return annotation.getKey("/Subtype").getName() == "/Link" && !annotation.hasKey("/A") &&
           !annotation.hasKey("/AA") && !annotation.hasKey("/AP");
}

std::string textOf(Handle dictionary, const char *key) {
    Handle value = dictionary.isDictionary() ? dictionary.getKey(key) : Handle::newNull();
    return value.isString() ? value.getUTF8Value() : std::string();
}

/// Adds what a reading aid says instead of the page: alternative texts of the tagged parts.
void addTaggedTexts(std::vector<std::string> &result, const Handle &root) {
    std::set<QPDFObjGen> known;
    std::vector<Handle> next{root};
    while (!next.empty()) {
        Handle element = next.back();
        next.pop_back();
        // A damaged file has arrays, too, that lead back to themselves.
        if (element.isIndirect() && !known.insert(element.getObjGen()).second)
            continue;
        if (element.isArray()) {
            for (int i = element.getArrayNItems(); i-- > 0;)
                next.push_back(element.getArrayItem(i));
            continue;
        }
        if (!element.isDictionary())
            continue;
        for (const char *key : {"/Alt", "/ActualText", "/E", "/T"}) {
            if (element.hasKey(key))
                result.push_back(textOf(element, key));
        }
        next.push_back(element.getKey("/K"));
    }
}

/// Title, author, the bookmarks in reading order, then what reading aids say. Throws if the bookmarks do not
/// end.
std::vector<std::string> besideThePages(QPDF &document) {
    std::vector<std::string> result;
    for (const char *key : {"/Title", "/Author", "/Subject", "/Keywords"})
        result.push_back(textOf(document.getTrailer().getKey("/Info"), key));
    Handle outlines = document.getRoot().getKey("/Outlines");
    std::vector<Handle> next;
    if (outlines.isDictionary())
        next.push_back(outlines.getKey("/First"));
    while (!next.empty()) {
        Handle bookmark = next.back();
        next.pop_back();
        if (!bookmark.isDictionary())
            continue;
        if (result.size() > mostBookmarks)
            throw std::runtime_error("too many bookmarks");
        result.push_back(textOf(bookmark, "/Title"));
        next.push_back(bookmark.getKey("/Next"));
        next.push_back(bookmark.getKey("/First"));
    }
    addTaggedTexts(result, document.getRoot().getKey("/StructTreeRoot"));
    return result;
}

void addAnnotations(PdfParts &result, Handle page, int number) {
    if (page.hasKey("/AA"))
        result.additions.push_back({PdfAddition::Kind::action, number, "AA"});
    if (page.hasKey("/UserUnit")) // changes the scale
        result.additions.push_back({PdfAddition::Kind::action, number, "UserUnit"});
    Handle annotations = page.getKey("/Annots");
    const double height = page.getKey("/MediaBox").getArrayAsRectangle().ury;
    for (int i = 0; annotations.isArray() && i < annotations.getArrayNItems(); ++i) {
        Handle annotation = annotations.getArrayItem(i);
        if (!annotation.isDictionary() || !annotation.getKey("/Subtype").isName())
            continue;
        const std::string kind = annotation.getKey("/Subtype").getName();
        if (kind == "/Widget" && isSignature(annotation) && !annotation.hasKey("/AA")) {
            const PdfField field = fieldOf(number, annotation, height);
            if (field.left < field.right && field.top < field.bottom)
                result.signatureFields.push_back(field);
        } else if (kind == "/Widget") {
            result.additions.push_back({PdfAddition::Kind::form, number, {}});
        } else if (!isOwnLink(annotation)) {
            result.additions.push_back({PdfAddition::Kind::annotation, number, kind.substr(1)});
        } else {
            result.beside.push_back(textOf(annotation, "/Contents"));
        }
    }
}

/// Unpacks all streams once, so that their total size is known to be within the limit.
void requireTame(QPDF &document) {
    for (Handle object : document.getAllObjects()) {
        if (!object.isStream())
            continue;
        Pl_Discard nowhere;
        object.pipeStreamData(&nowhere, 0, qpdf_dl_specialized, true);
        if (UnpackingBound::isExceeded())
            return;
    }
}

/// False if the file is encrypted with an unknown password or by an unsupported method.
bool canOpen(QPDF &document, const char *bytes, std::size_t size) {
    try {
        document.processMemoryFile("report", bytes, size);
        return true;
    } catch (const QPDFExc &error) {
        if (error.getErrorCode() != qpdf_e_password && error.getErrorCode() != qpdf_e_unsupported)
            throw;
        return false;
    }
}

PdfParts dissected(QPDF &document) {
    PdfParts result;
    result.encrypted = document.isEncrypted();
    if (result.encrypted)
        return result;
    Handle packet = document.getRoot().getKey("/Metadata");
    if (packet.isStream())
        result.xmp = bytesOf(packet);
    for (const FoundFile &file : embeddedFiles(document))
        result.files.push_back({file.name, bytesOf(file.stream)});
    addActions(result.additions, document);
    const std::vector<Handle> &pages = document.getAllPages();
    if (pages.size() > mostPages)
        throw std::runtime_error("too many pages");
    result.beside = besideThePages(document);
    for (std::size_t i = 0; i < pages.size(); ++i)
        addAnnotations(result, pages[i], static_cast<int>(i) + 1);
    requireTame(document);
    if (document.anyWarnings()) // the library read on; another reader may not find the attachment
        throw std::runtime_error("damaged");
    return result;
}

} // namespace

PdfParts pdfParts(const char *bytes, std::size_t size, std::int64_t most, bool &exceeded) {
    const UnpackingBound bound(most);
    exceeded = false;
    try {
        QPDF document;
        document.setSuppressWarnings(true);
        document.setAttemptRecovery(false);
        if (!canOpen(document, bytes, size)) {
            PdfParts closed;
            closed.encrypted = true;
            return closed;
        }
        PdfParts result = dissected(document);
        if (UnpackingBound::isExceeded())
            throw std::runtime_error("unpacks to more than is read");
        return result;
    } catch (const std::exception &) { // anything the library throws
        exceeded = UnpackingBound::isExceeded();
        throw;
    }
}

} // namespace palmer
