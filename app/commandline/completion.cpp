// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/help.h"

#include "commandline/command.h"
#include "document/jsonformats.h"
#include "import/choices.h"
#include "kernel/evaluation/edition.h"

#include <algorithm>

namespace palmer {

namespace {

class Completion {
public:
    Completion(const QStringList &words, const Language &language)
        : m_language(language)
        , m_typed(words.value(words.size() - 1)) {
        for (qsizetype i = 0; i + 1 < words.size(); ++i)
            read(words[i]);
        if (m_open)
            valuesOf(*m_open, {});
        else if (m_typed.startsWith(u'-'))
            options();
        else if (!m_command)
            names();
        else
            arguments();
    }

    [[nodiscard]] QString text() const { return m_text; }

private:
    /// Processes a completed word.
    void read(const QString &word) {
        if (m_open) {
            m_open = nullptr; // this word is its value
            return;
        }
        const auto command = std::ranges::find_if(
            commands(), [&](const Command &each) { return word == QLatin1StringView(each.name); });
        if (!m_command && command != commands().end())
            m_command = &*command;
        else if (m_command && !word.startsWith(u'-'))
            m_arguments << word;
        const Option *option = optionCalled(word);
        m_open = option && *option->value != 0 ? option : nullptr;
        m_asksHelp |= word == QLatin1StringView("--help");
    }

    [[nodiscard]] const Option *optionCalled(const QString &word) const {
        const auto isIt = [&](const Option &option) { return dashed(option) == word; };
        const auto own = m_command ? m_command->options : std::span<const Option>();
        if (const auto found = std::ranges::find_if(own, isIt); found != own.end())
            return &*found;
        const auto found = std::ranges::find_if(commonOptions(), isIt);
        return found == commonOptions().end() ? nullptr : &*found;
    }

    void add(const QString &word, const QString &meaning) {
        if (word.startsWith(m_typed))
            m_text += word + u'\t' + meaning + u'\n';
    }

    void names() {
        for (const Command &command : commands())
            add(QString::fromUtf8(command.name), m_language.text(command.description));
        add(QStringLiteral("help"), m_language.text(REPORT_TEXT("report", "this help")));
    }

    void options() {
        const qsizetype mark = m_typed.indexOf(u'=');
        if (const Option *option = mark < 0 ? nullptr : optionCalled(m_typed.left(mark))) {
            valuesOf(*option, m_typed.left(mark + 1));
            return;
        }
        const auto addAll = [&](std::span<const Option> list) {
            for (const Option &option : list)
                add(dashed(option), m_language.text(option.description));
        };
        if (m_command) {
            const QString part = m_arguments.value(0); // or a file
            addAll(optionsOf(*m_command, partsOf(*m_command).contains(part) ? part : QString()));
        }
        for (const Option &option : commonOptions()) {
            if (!m_command || !findOption(m_command->options, QString::fromUtf8(option.name)))
                addAll({&option, 1});
        }
    }

    /// `before`: text before the value in the same word.
    void valuesOf(const Option &option, const QString &before) {
        for (const QString &word : wordsOf(option))
            add(before + word, {});
        const QLatin1StringView name(option.name);
        if (name == QLatin1StringView("edition") || name == QLatin1StringView("editions")) {
            for (const Edition *edition : editions())
                add(before + QString::fromUtf8(edition->word).remove(u' '), {}); // spaces would split words
        } else if (name == QLatin1StringView("set")) {
            for (const ImportKey &key : importKeys())
                choices(key, before + QString::fromUtf8(key.key) + u'=');
        }
    }

    /// Offers the key first, then its words.
    void choices(const ImportKey &key, const QString &typedKey) {
        if (!m_typed.startsWith(typedKey)) {
            add(typedKey, m_language.text(key.name));
            return;
        }
        for (const ImportWord &word : key.words)
            add(typedKey + QString::fromUtf8(word.word).replace(u' ', QStringLiteral("\\ ")),
                m_language.text(word.name));
    }

    void arguments() {
        if (m_asksHelp && takesKeys(*m_command))
            add(QString::fromUtf8(keysWord), {});
        else if (!m_arguments.isEmpty())
            return;
        else if (m_command->arguments == std::string_view("[NAME]"))
            for (const JsonFormat &row : jsonFormats())
                add(QString::fromUtf8(row.name), QString::fromUtf8(row.command));
        else
            for (const QString &word : partsOf(*m_command))
                add(word, {});
    }

    const Language &m_language;
    QString m_typed;
    const Command *m_command = nullptr;
    QStringList m_arguments;
    const Option *m_open = nullptr; ///< option that expects the next value
    bool m_asksHelp = false;
    QString m_text;
};

} // namespace

QString completion(const QStringList &words, const Language &language) {
    return Completion(words, language).text();
}

} // namespace palmer
