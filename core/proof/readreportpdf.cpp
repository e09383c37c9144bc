#include "proof/readreportpdf.h"

#include "document/savedocument.h"
#include "document/testfile.h"
#include "proof/pdffilters.h"

#include <qpdf/Pl_Discard.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;

constexpr int mostPages = 20'000;

[[noreturn]] void refuse(Error::Kind kind, Text text, std::vector<Argument> arguments = {}) {
    throw Error(kind, {text, std::move(arguments), {}});
}

[[noreturn]] void refuseDamaged() {
    refuse(
        Error::Kind::syntax,
        REPORT_TEXT("report", "this PDF is damaged and cannot be read; ask for it again where it came from"));
}

[[noreturn]] void refuseForeign() {
    refuse(Error::Kind::content,
           REPORT_TEXT("report",
                       "this PDF is no report of Palmer with its test file inside: there is nothing "
                       "to open or to verify"));
}

QByteArray bytesOf(Handle stream) {
    const auto buffer = stream.getStreamData(qpdf_dl_specialized);
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

/// A file inside the PDF, by whichever way a reader finds it.
struct EmbeddedFile {
    QString name;
    std::string relationship;
    Handle stream;
    QPDFObjGen id;
};

/// Throws for a specification whose names lead to different files: readers would show one or the other.
std::optional<EmbeddedFile> embeddedFile(Handle specification) {
    if (!specification.isDictionary())
        return {};
    Handle files = specification.getKey("/EF");
    if (!files.isDictionary())
        return {};
    EmbeddedFile result;
    for (const std::string &key : files.getKeys()) {
        Handle stream = files.getKey(key);
        if (!stream.isStream())
            continue;
        if (result.stream.isInitialized() && !(result.id == stream.getObjGen()))
            refuseDamaged();
        result.stream = stream;
        result.id = stream.getObjGen();
    }
    if (!result.stream.isInitialized())
        return {};
    for (const char *key : {"/UF", "/F"}) {
        if (result.name.isEmpty() && specification.getKey(key).isString())
            result.name = QString::fromStdString(specification.getKey(key).getUTF8Value());
    }
    if (specification.getKey("/AFRelationship").isName())
        result.relationship = specification.getKey("/AFRelationship").getName();
    return result;
}

std::vector<EmbeddedFile> embeddedFiles(QPDF &document) {
    std::vector<EmbeddedFile> files;
    const auto add = [&files](const Handle &specification) {
        const auto file = embeddedFile(specification);
        const bool isNew = file && std::ranges::none_of(files, [&](const EmbeddedFile &other) {
                               return other.id == file->id && other.name == file->name &&
                                      other.relationship == file->relationship;
                           });
        if (isNew)
            files.push_back(*file);
    };
    QPDFEmbeddedFileDocumentHelper helper(document);
    for (const auto &[key, file] : helper.getEmbeddedFiles())
        add(file->getObjectHandle());
    Handle associated = document.getRoot().getKey("/AF");
    if (associated.isArray()) {
        for (int i = 0; i < associated.getArrayNItems(); ++i)
            add(associated.getArrayItem(i));
    }
    return files;
}

void addUnknownKeys(std::vector<Addition> &additions, Handle dictionary,
                    std::initializer_list<std::string_view> known, int page = 0) {
    if (!dictionary.isDictionary())
        return;
    for (const std::string &key : dictionary.getKeys()) {
        if (std::ranges::find(known, std::string_view(key)) == known.end())
            additions.push_back({Addition::Kind::action, page, QString::fromStdString(key.substr(1))});
    }
}

/// What the file may do beyond showing its pages.
void addActions(std::vector<Addition> &additions, QPDF &document) {
    Handle root = document.getRoot();
    addUnknownKeys(additions, root,
                   {"/Type", "/Version", "/Extensions", "/Pages", "/PageLabels", "/Names",
                    "/ViewerPreferences", "/PageLayout", "/PageMode", "/Outlines", "/AcroForm", "/Metadata",
                    "/MarkInfo", "/Lang", "/OutputIntents", "/Perms", "/DSS", "/AF"});
    addUnknownKeys(additions, root.getKey("/Names"), {"/EmbeddedFiles"});
    Handle form = root.getKey("/AcroForm");
    addUnknownKeys(additions, form, {"/Fields", "/SigFlags", "/DR", "/DA", "/Q", "/NeedAppearances"});
}

QRectF areaOf(Handle annotation, double height) {
    const Handle::Rectangle box = annotation.getKey("/Rect").getArrayAsRectangle();
    return {QPointF(box.llx, height - box.ury), QPointF(box.urx, height - box.lly)};
}

bool isSignature(Handle widget) {
    constexpr int deepest = 8;
    Handle field = widget;
    for (int i = 0; i < deepest && field.isDictionary(); ++i) {
        if (field.getKey("/FT").isName())
            return field.getKey("/FT").getName() == "/Sig";
        field = field.getKey("/Parent");
    }
    return false;
}

/// A link of ours leads to another page of the report and nowhere else.
bool isOwnLink(Handle annotation) {
    return annotation.getKey("/Subtype").getName() == "/Link" && !annotation.hasKey("/A") &&
           !annotation.hasKey("/AA") && !annotation.hasKey("/AP");
}

void addAnnotations(ReportPdf &result, Handle page, int number) {
    if (page.hasKey("/AA"))
        result.additions.push_back({Addition::Kind::action, number, QStringLiteral("AA")});
    Handle annotations = page.getKey("/Annots");
    const double height = page.getKey("/MediaBox").getArrayAsRectangle().ury;
    for (int i = 0; annotations.isArray() && i < annotations.getArrayNItems(); ++i) {
        Handle annotation = annotations.getArrayItem(i);
        if (!annotation.isDictionary() || !annotation.getKey("/Subtype").isName())
            continue;
        const std::string kind = annotation.getKey("/Subtype").getName();
        if (kind == "/Widget" && isSignature(annotation) && !annotation.hasKey("/AA")) {
            const QRectF area = areaOf(annotation, height);
            if (!area.isEmpty())
                result.signatureFields.push_back({number, area});
        } else if (kind == "/Widget") {
            result.additions.push_back({Addition::Kind::form, number, {}});
        } else if (!isOwnLink(annotation)) {
            result.additions.push_back(
                {Addition::Kind::annotation, number, QString::fromStdString(kind.substr(1))});
        }
    }
}

/// Unpacks all there is once, so that what comes after may rely on its size.
void demandTame(QPDF &document) {
    for (Handle object : document.getAllObjects()) {
        if (!object.isStream())
            continue;
        Pl_Discard nowhere;
        object.pipeStreamData(&nowhere, 0, qpdf_dl_specialized, true);
        if (UnpackingBound::isExceeded())
            return;
    }
}

ReportPdf takeApart(QPDF &document) {
    if (document.isEncrypted())
        refuse(Error::Kind::content,
               REPORT_TEXT("report", "this PDF is encrypted; save it without password and open that"));
    Handle packet = document.getRoot().getKey("/Metadata");
    const auto metadata = packet.isStream() ? readXmp(bytesOf(packet)) : std::nullopt;
    ReportPdf result;
    std::size_t testFiles = 0;
    for (const EmbeddedFile &file : embeddedFiles(document)) {
        if (isTestFileName(file.name)) {
            result.testFile = bytesOf(file.stream);
            result.testFileName = file.name;
            ++testFiles;
        } else if (file.name == QLatin1StringView("results.json") && result.results.isEmpty()) {
            result.results = bytesOf(file.stream);
        } else {
            result.additions.push_back({Addition::Kind::attachment, 0, file.name});
        }
    }
    if (!metadata || testFiles == 0)
        refuseForeign();
    if (testFiles > 1)
        refuse(Error::Kind::content,
               REPORT_TEXT("report", "this PDF carries more than one test file, and which of them the report "
                                     "was made from is not known"));
    result.metadata = *metadata;
    addActions(result.additions, document);
    const std::vector<Handle> &pages = document.getAllPages();
    if (pages.size() > mostPages)
        refuseDamaged();
    for (std::size_t i = 0; i < pages.size(); ++i)
        addAnnotations(result, pages[i], static_cast<int>(i) + 1);
    demandTame(document);
    return result;
}

} // namespace

bool isPdf(QByteArrayView bytes) {
    return bytes.startsWith("%PDF-");
}

ReportPdf readReportPdf(const QByteArray &pdf) {
    demandReadable(pdf.size());
    const UnpackingBound bound(mostUnpacked);
    const auto demandBounded = [] {
        if (UnpackingBound::isExceeded())
            refuse(Error::Kind::tooLarge,
                   REPORT_TEXT("report", "this PDF unpacks to more than %1 MB and is not read"),
                   {Number{static_cast<double>(mostUnpacked >> 20), Quantity::count, 0}});
    };
    try {
        QPDF document;
        document.setSuppressWarnings(true);
        document.setAttemptRecovery(false); // what another reader makes of a ruin is not known
        document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
        ReportPdf result = takeApart(document);
        demandBounded();
        return result;
    } catch (const Error &) {
        demandBounded();
        throw;
    } catch (const std::exception &) { // whatever the library throws
        demandBounded();
        refuseDamaged();
    }
}

} // namespace palmer
