// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/reportmetadata.h"

#include "kernel/evaluation/edition.h"
#include "language/language.h"

#include <QXmlStreamReader>
#include <QXmlStreamWriter>
#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace palmer {

namespace {

constexpr QLatin1StringView rdf("http://www.w3.org/1999/02/22-rdf-syntax-ns#");
constexpr QLatin1StringView dc("http://purl.org/dc/elements/1.1/");
constexpr QLatin1StringView xmp("http://ns.adobe.com/xap/1.0/");
constexpr QLatin1StringView pdfaId("http://www.aiim.org/pdfa/ns/id/");
constexpr QLatin1StringView pdfuaId("http://www.aiim.org/pdfua/ns/id/");
constexpr QLatin1StringView pdfaExtension("http://www.aiim.org/pdfa/ns/extension/");
constexpr QLatin1StringView pdfaSchema("http://www.aiim.org/pdfa/ns/schema#");
constexpr QLatin1StringView pdfaProperty("http://www.aiim.org/pdfa/ns/property#");
constexpr QLatin1StringView own("urn:palmer:report:1#");

constexpr QLatin1StringView programName("Program");
constexpr QLatin1StringView languageName("Language");
constexpr QLatin1StringView selfTestName("SelfTest");
constexpr QLatin1StringView simulatedName("Simulated");
constexpr QLatin1StringView editionName("Edition"); // only if another edition was chosen
constexpr QLatin1StringView leftOutName("LeftOut"); // only if the annex is
constexpr QLatin1StringView annexWord("annex");

constexpr QLatin1StringView passed("passed");
constexpr QLatin1StringView failed("failed");
constexpr QLatin1StringView notRun("not run");

struct OwnProperty {
    QLatin1StringView name;
    const char *description = nullptr;
};

// PDF/A requires a description of every property outside the known schemas.
constexpr std::array ownProperties{
    OwnProperty{programName, "Program and version that made the report"},
    OwnProperty{languageName, "Language of the report"},
    OwnProperty{selfTestName, "Result of the self-test of the program: passed, failed, not run"},
    OwnProperty{simulatedName, "Tests whose uncertainty was simulated, counted from 1"},
};
constexpr std::array uaProperties{
    OwnProperty{QLatin1StringView("part"), "Part of ISO 14289 that the file conforms to"},
};
constexpr std::array viewProperties{
    OwnProperty{editionName, "Edition that the tests of its kind are evaluated under instead of their own"},
};

constexpr std::array leftOutProperties{
    OwnProperty{leftOutName, "Part of the report that was left out"},
};

QString selfTestWord(std::optional<bool> isPassed) {
    if (!isPassed)
        return notRun;
    return *isPassed ? passed : failed;
}

QString simulatedWords(const std::vector<int> &tests) {
    QStringList words;
    for (const int test : tests)
        words << QString::number(test);
    return words.join(u' ');
}

class PacketWriter {
public:
    explicit PacketWriter(QByteArray &bytes)
        : m_xml(&bytes) {
        m_xml.setAutoFormatting(true);
        m_xml.setAutoFormattingIndent(1);
    }

    void write(const ReportMetadata &metadata) {
        m_xml.writeNamespace(QStringLiteral("adobe:ns:meta/"), QStringLiteral("x"));
        m_xml.writeStartElement(QStringLiteral("adobe:ns:meta/"), QStringLiteral("xmpmeta"));
        m_xml.writeNamespace(rdf, QStringLiteral("rdf"));
        m_xml.writeStartElement(rdf, QStringLiteral("RDF"));
        writeCommon(metadata);
        writeOwn(metadata);
        writeSchema(metadata);
        m_xml.writeEndElement();
        m_xml.writeEndElement();
    }

private:
    void beginDescription(std::initializer_list<std::pair<QLatin1StringView, const char *>> namespaces) {
        for (const auto &[uri, prefix] : namespaces)
            m_xml.writeNamespace(uri, QString::fromLatin1(prefix));
        m_xml.writeStartElement(rdf, QStringLiteral("Description"));
        m_xml.writeAttribute(rdf, QStringLiteral("about"), QString());
    }

    /// An array with one item.
    void item(QLatin1StringView uri, const char *name, const char *kind, const QString &text) {
        m_xml.writeStartElement(uri, QString::fromLatin1(name));
        m_xml.writeStartElement(rdf, QString::fromLatin1(kind));
        m_xml.writeStartElement(rdf, QStringLiteral("li"));
        if (QLatin1StringView(kind) == QLatin1StringView("Alt"))
            m_xml.writeAttribute(QStringLiteral("xml:lang"), QStringLiteral("x-default"));
        m_xml.writeCharacters(text);
        m_xml.writeEndElement();
        m_xml.writeEndElement();
        m_xml.writeEndElement();
    }

    void writeCommon(const ReportMetadata &metadata) {
        beginDescription({{pdfaId, "pdfaid"}, {pdfuaId, "pdfuaid"}, {dc, "dc"}, {xmp, "xmp"}});
        m_xml.writeTextElement(pdfaId, QStringLiteral("part"), QStringLiteral("3"));
        m_xml.writeTextElement(pdfaId, QStringLiteral("conformance"), QStringLiteral("A"));
        m_xml.writeTextElement(pdfuaId, QStringLiteral("part"), QStringLiteral("1"));
        m_xml.writeTextElement(dc, QStringLiteral("format"), QStringLiteral("application/pdf"));
        if (!metadata.title.isEmpty())
            item(dc, "title", "Alt", metadata.title);
        if (!metadata.author.isEmpty())
            item(dc, "creator", "Seq", metadata.author);
        if (!metadata.language.isEmpty())
            item(dc, "language", "Bag", metadata.language);
        m_xml.writeTextElement(xmp, QStringLiteral("CreatorTool"), QStringLiteral("Palmer"));
        if (!metadata.date.isEmpty()) {
            const QString time = metadata.date + QStringLiteral("T00:00:00Z");
            for (const char *name : {"CreateDate", "ModifyDate", "MetadataDate"})
                m_xml.writeTextElement(xmp, QString::fromLatin1(name), time);
        }
        m_xml.writeEndElement();
    }

    void writeOwn(const ReportMetadata &metadata) {
        beginDescription({{own, "palmer"}});
        m_xml.writeTextElement(own, programName, metadata.making.program);
        m_xml.writeTextElement(own, languageName, metadata.language);
        m_xml.writeTextElement(own, selfTestName, selfTestWord(metadata.making.selfTestPassed));
        m_xml.writeTextElement(own, simulatedName, simulatedWords(metadata.making.simulated));
        if (!metadata.making.edition.isEmpty())
            m_xml.writeTextElement(own, editionName, metadata.making.edition);
        if (!metadata.making.annex)
            m_xml.writeTextElement(own, leftOutName, annexWord);
        m_xml.writeEndElement();
    }

    void beginResource(QLatin1StringView uri, const QString &name) {
        m_xml.writeStartElement(uri, name);
        m_xml.writeAttribute(rdf, QStringLiteral("parseType"), QStringLiteral("Resource"));
    }

    void beginBag(QLatin1StringView uri, const char *name, const char *kind) {
        m_xml.writeStartElement(uri, QString::fromLatin1(name));
        m_xml.writeStartElement(rdf, QString::fromLatin1(kind));
    }

    void endBag() {
        m_xml.writeEndElement();
        m_xml.writeEndElement();
    }

    void describe(std::span<const OwnProperty> properties, const char *type = "Text") {
        for (const OwnProperty &property : properties) {
            beginResource(rdf, QStringLiteral("li"));
            m_xml.writeTextElement(pdfaProperty, QStringLiteral("name"), property.name);
            m_xml.writeTextElement(pdfaProperty, QStringLiteral("valueType"), QString::fromLatin1(type));
            m_xml.writeTextElement(pdfaProperty, QStringLiteral("category"), QStringLiteral("internal"));
            m_xml.writeTextElement(pdfaProperty, QStringLiteral("description"),
                                   QString::fromLatin1(property.description));
            m_xml.writeEndElement();
        }
    }

    void beginSchema(const char *name, QLatin1StringView uri, const char *prefix) {
        beginResource(rdf, QStringLiteral("li"));
        m_xml.writeTextElement(pdfaSchema, QStringLiteral("schema"), QString::fromLatin1(name));
        m_xml.writeTextElement(pdfaSchema, QStringLiteral("namespaceURI"), uri);
        m_xml.writeTextElement(pdfaSchema, QStringLiteral("prefix"), QString::fromLatin1(prefix));
        beginBag(pdfaSchema, "property", "Seq");
    }

    void writeSchema(const ReportMetadata &metadata) {
        beginDescription(
            {{pdfaExtension, "pdfaExtension"}, {pdfaSchema, "pdfaSchema"}, {pdfaProperty, "pdfaProperty"}});
        beginBag(pdfaExtension, "schemas", "Bag");
        beginSchema("PDF/UA identification schema", pdfuaId, "pdfuaid");
        describe(uaProperties, "Integer");
        endBag();
        m_xml.writeEndElement();
        beginSchema("Palmer report", own, "palmer");
        describe(ownProperties);
        if (!metadata.making.edition.isEmpty())
            describe(viewProperties);
        if (!metadata.making.annex)
            describe(leftOutProperties);
        endBag();
        m_xml.writeEndElement();
        endBag();
        m_xml.writeEndElement();
    }

    QXmlStreamWriter m_xml;
};

std::optional<std::vector<int>> simulatedTests(const QString &words) {
    std::vector<int> result;
    for (const QString &word : words.split(u' ', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int test = word.toInt(&isNumber);
        if (!isNumber || test < 1 || (!result.empty() && test <= result.back()))
            return std::nullopt;
        result.push_back(test);
    }
    return result;
}

} // namespace

QByteArray xmpPacket(const ReportMetadata &metadata) {
    QByteArray body;
    PacketWriter(body).write(metadata);
    return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n" + body.trimmed() +
           "\n<?xpacket end=\"r\"?>\n";
}

namespace {

/// Palmer's own properties by name; title and author are stored in `result`. Null if the packet is not well
/// formed or states a property twice.
std::optional<std::map<QString, QString>> propertiesOf(const QByteArray &packet, ReportMetadata &result) {
    std::map<QString, QString> found;
    QXmlStreamReader xml(packet);
    while (!xml.atEnd()) {
        const bool begins = xml.readNext() == QXmlStreamReader::StartElement;
        if (begins && xml.namespaceUri() == dc) {
            QString *shown = xml.name() == QLatin1StringView("title")     ? &result.title
                             : xml.name() == QLatin1StringView("creator") ? &result.author
                                                                          : nullptr;
            if (shown)
                *shown += xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
        } else if (begins && xml.namespaceUri() == own) {
            const QString name = xml.name().toString();
            if (!found.emplace(name, xml.readElementText()).second)
                return std::nullopt;
        }
    }
    return xml.hasError() ? std::nullopt : std::optional(std::move(found));
}

} // namespace

std::optional<ReportMetadata> readXmp(const QByteArray &packet) {
    ReportMetadata result;
    auto properties = propertiesOf(packet, result);
    if (!properties)
        return std::nullopt;
    std::map<QString, QString> &found = *properties;
    const bool complete = std::ranges::all_of(
        ownProperties, [&](const OwnProperty &property) { return found.contains(property.name); });
    const bool isView = found.contains(editionName);
    result.making.annex = !found.contains(leftOutName);
    if (!complete || found.size() != ownProperties.size() + isView + !result.making.annex)
        return std::nullopt;
    if (!result.making.annex && found[leftOutName] != annexWord)
        return std::nullopt;
    result.making.program = found[programName];
    result.language = found[languageName];
    if (!Language::fromName(result.language))
        return std::nullopt;
    const QString selfTest = found[selfTestName];
    if (selfTest != notRun && selfTest != passed && selfTest != failed)
        return std::nullopt;
    if (selfTest != notRun)
        result.making.selfTestPassed = selfTest == passed;
    const auto simulated = simulatedTests(found[simulatedName]);
    if (!simulated)
        return std::nullopt;
    result.making.simulated = *simulated;
    if (isView) {
        result.making.edition = found[editionName];
        if (!findEdition(result.making.edition.toStdString()))
            return std::nullopt;
    }
    return result;
}

} // namespace palmer
