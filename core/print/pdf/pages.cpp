// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/pages.h"

#include "print/pdf/strips.h"
#include "print/pdf/tags.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <set>

namespace palmer {

namespace {

constexpr double leftMargin = 20 * mm;
constexpr double rightMargin = 15 * mm;
constexpr double topMargin = 15 * mm;
constexpr double bottomMargin = 18 * mm;
constexpr double footerRule = 14 * mm;    ///< above the page edge
constexpr double footerText = 1.3 * mm;   ///< below its rule
constexpr double runningRule = 1.45 * mm; ///< below its text
constexpr double belowRunningHead = 6 * mm;
constexpr double narrowlyBelow = 3 * mm;
/// Gaps from this size on may shrink to this fraction to keep the results on the first page.
constexpr double smallestToNarrow = 1.5 * mm;
constexpr double slightlyNarrower = 0.7;
constexpr double narrowest = 0.4;
constexpr double closest = 0.25;            ///< in a certificate that is set narrow
constexpr double leastOnFurtherPages = 0.8; ///< fraction of its height
constexpr double roundingRoom = 0.01;
constexpr double largestGap = 8.5 * mm; ///< if the page has space
constexpr double leastFill = 0.45;      ///< of the last page before a break, if something can be moved there
constexpr double sectionRoom = 25 * mm; ///< minimum below the top of a section

constexpr TextStyle runningStyle{7.5, false, noteGrey, 1.2};

double runningHeadHeight(bool narrow = false) {
    return runningStyle.size * runningStyle.leading + runningRule +
           (narrow ? narrowlyBelow : belowRunningHead);
}

QSizeF sizeOf(Paper paper) {
    return paper == Paper::letter ? QSizeF(612, 792) : QSizeF(210, 297) * mm;
}

TextBlock elided(const QString &text, double width) {
    return palmer::elided(text, runningStyle, width);
}

/// StripPlaces of one page before they are positioned.
struct PageStrips {
    std::shared_ptr<const RunningHead> running;
    StripPlaces strips;
    bool narrow = false; ///< less below the running head

    [[nodiscard]] double top() const { return topMargin + (running ? runningHeadHeight(narrow) : 0); }
    [[nodiscard]] double used() const {
        double height = 0;
        for (const StripPlace &strip : strips)
            height += strip.height + (&strip == &strips.front() ? 0 : strip.gap);
        return height;
    }
};

/// The head of the table that a strip goes on with.
StripPlace repeatedHead(const StripPlace &strip) {
    StripPlace head = *strip.head;
    head.owner = strip.owner;
    return head;
}

/// Distributes strips over pages.
class Flow {
public:
    explicit Flow(double bottom)
        : m_bottom(bottom) {}

    void fill(const StripPlaces &strips) {
        m_early.assign(strips.size(), false);
        for (std::size_t i = 0; i < strips.size();) {
            if (m_early[i]) {
                ++i;
            } else if (strips[i].pageBreak) {
                const bool goesOn = strips[i].soft && m_page.running;
                if (!m_page.strips.empty() && !goesOn)
                    endPart();
                ++i;
            } else if (strips[i].running) {
                m_running = strips[i].running;
                m_narrow = strips[i].narrow;
                if (m_page.strips.empty())
                    m_page.running.reset();
                ++i;
            } else {
                i = fillRest(strips, i);
                const std::size_t end = chainEnd(strips, i);
                placeChain(strips, i, end);
                i = end;
            }
        }
        if (!m_page.strips.empty() || m_pages.empty())
            endPart();
    }

    [[nodiscard]] const std::vector<PageStrips> &pages() const { return m_pages; }
    [[nodiscard]] std::vector<PageStrips> takePages() { return std::move(m_pages); }

private:
    /// End of the strips that must stay together with the one at `from`.
    static std::size_t chainEnd(const StripPlaces &strips, std::size_t from) {
        std::size_t end = from + 1;
        while (end < strips.size() && strips[end - 1].withNext && !strips[end].pageBreak &&
               !strips[end].running)
            ++end;
        return end;
    }

    /// End of the section that begins at `from`.
    static std::size_t sectionEnd(const StripPlaces &strips, std::size_t from) {
        std::size_t end = from + 1;
        while (end < strips.size() && !strips[end].section && !strips[end].pageBreak && !strips[end].running)
            ++end;
        return end;
    }

    /// If the section at `from` does not fit, a later section of the same test that may be moved forward
    /// fills the page, below the title if `from` is one. Returns the index to continue at.
    std::size_t fillRest(const StripPlaces &strips, std::size_t from) {
        if (m_page.strips.empty() || !strips[from].section ||
            needed(strips, from, chainEnd(strips, from)) <= room())
            return from;
        const std::size_t next = from + (strips[from].title ? 1 : 0);
        std::size_t filler = next;
        while (filler < strips.size() && !strips[filler].filler && !strips[filler].pageBreak &&
               !strips[filler].running)
            ++filler;
        if (filler == strips.size() || !strips[filler].filler || m_early[filler] || filler == next)
            return from;
        const double above = needed(strips, from, next);
        const double least =
            std::max(needed(strips, filler, chainEnd(strips, filler)), strips[filler].gap + sectionRoom);
        if (above + least > room())
            return from;
        for (std::size_t i = from; i < next; ++i)
            place(strips[i]);
        const std::size_t end = sectionEnd(strips, filler);
        for (std::size_t i = filler; i < end;) {
            const std::size_t behind = chainEnd(strips, i);
            placeChain(strips, i, behind);
            i = behind;
        }
        std::fill(m_early.begin() + static_cast<std::ptrdiff_t>(filler),
                  m_early.begin() + static_cast<std::ptrdiff_t>(end), true);
        return next;
    }

    [[nodiscard]] double room() const { return m_bottom - m_page.top() - m_page.used(); }

    /// Height of the strips if placed next, including a repeated table head.
    [[nodiscard]] double needed(const StripPlaces &strips, std::size_t from, std::size_t end) const {
        double height = 0;
        const bool begins = m_page.strips.empty();
        if (begins && strips[from].head)
            height += strips[from].head->height;
        for (std::size_t i = from; i < end; ++i)
            height += strips[i].height + (begins && i == from ? 0 : strips[i].gap);
        return height;
    }

    void placeChain(const StripPlaces &strips, std::size_t from, std::size_t end) {
        double height = needed(strips, from, end);
        if (strips[from].section)
            height = std::max(height, strips[from].gap + sectionRoom);
        const auto at = [&](std::size_t i) { return strips.begin() + static_cast<std::ptrdiff_t>(i); };
        const bool results = std::any_of(at(from), at(end), std::mem_fn(&StripPlace::whole));
        if (!m_page.strips.empty() && height > room() &&
            !(results && narrowGaps(strips, from, end, height - room())) &&
            !lowerFigure(strips, from, end, height - room()))
            turnPage();
        if (m_narrowing < 1 || m_lowering > 0 || needed(strips, from, end) <= room()) {
            for (std::size_t i = from; i < end; ++i)
                place(strips[i]);
            return;
        }
        for (std::size_t i = from; i < end; ++i) { // higher than a page
            if (!m_page.strips.empty() && needed(strips, i, i + 1) > room())
                turnPage();
            place(strips[i]);
        }
    }

    /// To keep the results on the first page of a test, shrinks the larger gaps by a common factor, and then
    /// the figure.
    bool narrowGaps(const StripPlaces &strips, std::size_t from, std::size_t end, double missing) {
        if (m_narrowing < 1 || m_page.running)
            return false;
        double gaps = 0;
        const auto add = [&gaps](const StripPlace &strip) {
            gaps += strip.gap >= smallestToNarrow ? strip.gap : 0;
        };
        std::for_each(m_page.strips.begin(), m_page.strips.end(), add);
        for (std::size_t i = from; i < end; ++i)
            add(strips[i]);
        double figures = 0;
        for (const StripPlace &strip : m_page.strips)
            figures += strip.lowers ? strip.height - strip.least : 0;
        const double ofGaps = std::min(missing + roundingRoom, (1 - narrowest) * gaps);
        double ofFigures = missing + roundingRoom - ofGaps;
        if (gaps <= 0 || ofFigures > figures)
            return false;
        m_narrowing = 1 - ofGaps / gaps;
        for (StripPlace &strip : m_page.strips) {
            strip.gap = narrowed(strip.gap);
            const double less = strip.lowers ? std::min(ofFigures, strip.height - strip.least) : 0;
            strip.height -= less;
            strip.lowered = strip.lowered || less > 0;
            ofFigures -= less;
        }
        return true;
    }

    /// Shrinks a figure that does not fit rather than leave half a page blank: on the first page of a test
    /// down to its readable height, on others a little.
    bool lowerFigure(const StripPlaces &strips, std::size_t from, std::size_t end, double missing) {
        for (std::size_t i = from; i < end; ++i) {
            if (!strips[i].lowers)
                continue;
            const double least = m_page.running
                                     ? std::max(strips[i].least, leastOnFurtherPages * strips[i].height)
                                     : strips[i].least;
            if (strips[i].height - least < missing + roundingRoom)
                continue;
            m_lowering = missing + roundingRoom;
            return true;
        }
        return false;
    }

    [[nodiscard]] double narrowed(double gap) const {
        return gap < smallestToNarrow ? gap : m_narrowing * gap;
    }

    void place(const StripPlace &strip) {
        if (m_page.strips.empty() && strip.head)
            m_page.strips.push_back(repeatedHead(strip));
        m_page.strips.push_back(strip);
        StripPlace &placed = m_page.strips.back();
        placed.gap = narrowed(strip.gap);
        if (m_lowering > 0 && strip.lowers && strip.height - strip.least >= m_lowering) {
            placed.height -= m_lowering;
            placed.lowered = true;
            m_lowering = 0;
        }
    }

    /// Turns the page before a page break.
    void endPart() {
        turnPage();
        if (m_pages.size() - m_part > 1)
            fillLast(m_pages[m_pages.size() - 2], m_pages.back());
        m_part = m_pages.size();
    }

    /// True if a strip may be the first of a page that goes on with `next`: with `sections` only one that
    /// begins a section, otherwise also a row of a table, whose head is repeated, or a line of a paragraph
    /// that is split anyway.
    [[nodiscard]] static bool mayBegin(const PageStrips &page, std::size_t strip, const StripPlace &next,
                                       bool sections) {
        const StripPlace &first = page.strips[strip];
        const bool inBlock = first.block < 0 && (!first.inText || first.owner == next.owner);
        return !page.strips[strip - 1].withNext && (first.section || (inBlock && !sections));
    }

    /// If the last page of a part is emptier than it may be, moves the end of the page before to it:
    /// preferably sections, otherwise what may stand at the top of a page, but no results from the page of a
    /// head.
    void fillLast(PageStrips &before, PageStrips &last) const {
        const auto least = [this](const PageStrips &page) { return leastFill * (m_bottom - page.top()); };
        if (last.used() >= least(last))
            return;
        const bool repeatsHead =
            last.strips.size() > 1 && last.strips[1].head && last.strips[1].head == before.strips.back().head;
        for (const bool sections : {true, false}) {
            for (std::size_t i = before.strips.size(); i-- > 1;) {
                if (before.strips[i].whole && !before.running)
                    break;
                if (!mayBegin(before, i, last.strips.front(), sections))
                    continue;
                const auto from = before.strips.begin() + static_cast<std::ptrdiff_t>(i);
                const PageStrips kept{before.running, {before.strips.begin(), from}, before.narrow};
                PageStrips moved{last.running, {from, before.strips.end()}, last.narrow};
                if (from->head)
                    moved.strips.insert(moved.strips.begin(), repeatedHead(*from));
                moved.strips.insert(moved.strips.end(), last.strips.begin() + (repeatsHead ? 1 : 0),
                                    last.strips.end());
                if (moved.used() > m_bottom - moved.top() || kept.used() < least(kept))
                    break;
                if (moved.used() < least(moved))
                    continue;
                before = kept;
                last = moved;
                return;
            }
        }
    }

    void turnPage() {
        m_page.strips.shrink_to_fit();
        m_pages.push_back(std::move(m_page));
        m_page = {};
        m_page.running = m_running;
        m_page.narrow = m_narrow;
        m_narrowing = 1;
    }

    double m_bottom;
    std::vector<PageStrips> m_pages;
    std::size_t m_part = 0; ///< first page since a page break
    PageStrips m_page;
    std::shared_ptr<const RunningHead> m_running;
    bool m_narrow = false;     ///< less below it
    double m_narrowing = 1;    ///< factor for the larger gaps of this page
    std::vector<bool> m_early; ///< strips moved forward within their test
    double m_lowering = 0;     ///< reduction of the next figure's height
};

/// Calls `visit` with each strip, the block it belongs to, and its page, counted from 1.
void eachStrip(const Flow &flow, const auto &visit) {
    std::size_t block = 0;
    int page = 0;
    for (const PageStrips &content : flow.pages()) {
        ++page;
        for (const StripPlace &strip : content.strips) {
            if (strip.block >= 0)
                block = static_cast<std::size_t>(strip.block);
            visit(strip, block, page);
        }
    }
}

/// Page on which each block ends; 0: it has no strip.
std::vector<int> pagesOfBlocks(const Flow &flow, std::size_t count) {
    std::vector<int> result(count);
    eachStrip(flow, [&](const StripPlace &, std::size_t block, int page) {
        if (block < count)
            result[block] = page;
    });
    return result;
}

std::map<QString, int> anchorPages(const Flow &flow, const MeasuredBlocks &blocks) {
    std::map<QString, int> result;
    eachStrip(flow, [&](const StripPlace &strip, std::size_t block, int page) {
        const QString anchor = strip.block < 0 ? QString() : anchorOf(*blocks[block].block);
        if (!anchor.isEmpty())
            result.emplace(anchor, page);
    });
    return result;
}

auto placeOf(MeasuredBlocks &blocks, std::size_t i) {
    return blocks.begin() + static_cast<std::ptrdiff_t>(i);
}

template <class T>
const T *asA(const MeasuredBlock &block) {
    return std::get_if<T>(block.block.get());
}

/// End of the section that begins at `first`.
std::size_t endOfSection(const MeasuredBlocks &blocks, std::size_t first) {
    std::size_t end = first + 1;
    while (end < blocks.size() && !isMark(*blocks[end].block) && !beginsSection(*blocks[end].block))
        ++end;
    return end;
}

/// If the figure of a test does not fit on the page of its head, below the verdict, moves the (possibly
/// lower) results there. Returns true if blocks were moved.
bool moveResults(MeasuredBlocks &blocks, const std::vector<int> &pages, std::size_t head) {
    const std::size_t figure = head + 2;
    std::size_t results = figure; // a heading followed by a table
    while (results + 1 < blocks.size() && !isMark(*blocks[results].block) &&
           !(asA<Heading>(blocks[results]) && asA<Table>(blocks[results + 1])))
        ++results;
    if (results + 1 >= blocks.size() || isMark(*blocks[results].block) || results == figure ||
        pages[figure] == pages[head])
        return false;
    std::rotate(placeOf(blocks, figure), placeOf(blocks, results),
                placeOf(blocks, endOfSection(blocks, results)));
    return true;
}

/// Does so for each test. Returns true if blocks were moved.
bool moveAllResults(MeasuredBlocks &blocks, const Flow &flow) {
    const std::vector<int> pages = pagesOfBlocks(flow, blocks.size());
    bool moved = false;
    for (std::size_t head = 0; head + 2 < blocks.size(); ++head) {
        if (asA<TestHead>(blocks[head]) && asA<VerdictLine>(blocks[head + 1]))
            moved |= moveResults(blocks, pages, head);
    }
    return moved;
}

/// Sorts the blocks in page order. Returns true if that changes their order.
bool followPages(MeasuredBlocks &blocks, const Flow &flow) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> places(blocks.size(), none);
    std::size_t place = 0;
    eachStrip(flow, [&](const StripPlace &strip, std::size_t block, int) {
        if (strip.block >= 0)
            places[block] = ++place;
    });
    std::size_t last = 0; // blocks without strips stay after those above them
    for (std::size_t &each : places) {
        each = each == none ? last : each;
        last = std::max(last, each);
    }
    if (std::ranges::is_sorted(places))
        return false;
    std::vector<std::size_t> order(blocks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i]; });
    MeasuredBlocks result;
    result.reserve(blocks.size());
    for (const std::size_t i : order)
        result.push_back(std::move(blocks[i]));
    blocks = std::move(result);
    return true;
}

/// Height of each block with the gap above it; 0: it has no strip.
std::vector<double> heightsOfBlocks(const Flow &flow, std::size_t count) {
    std::vector<double> result(count);
    eachStrip(flow, [&](const StripPlace &strip, std::size_t block, int) {
        if (block < count)
            result[block] += strip.gap + strip.height;
    });
    return result;
}

/// End of the sections from `first` on that fit completely at the end of a page, at most `most` of them.
std::size_t endOfWhatFits(const MeasuredBlocks &blocks, std::size_t first, const std::vector<double> &heights,
                          const PageStrips &page, double bottom,
                          std::size_t most = std::numeric_limits<std::size_t>::max()) {
    double room = bottom - page.top() - page.used() - roundingRoom;
    std::size_t taken = first;
    for (std::size_t count = 0; count < most && taken < blocks.size() && beginsSection(*blocks[taken].block);
         ++count) {
        const std::size_t next = endOfSection(blocks, taken);
        const double height = std::accumulate(heights.begin() + static_cast<std::ptrdiff_t>(taken),
                                              heights.begin() + static_cast<std::ptrdiff_t>(next), 0.0);
        const auto *heading = asA<Heading>(blocks[taken]);
        if ((heading && heading->level == 1) || std::max(height, sectionGap + sectionRoom) > room)
            break;
        room -= height;
        taken = next;
    }
    return taken;
}

/// Fills the page of the summary of all tests with as many sections as fit completely, from the first with an
/// anchor on. Returns true if blocks were moved.
bool fillSummary(MeasuredBlocks &blocks, const Flow &flow, double bottom) {
    const auto indexOf = [&](auto found) { return static_cast<std::size_t>(found - blocks.begin()); };
    const auto isSummary = [](const MeasuredBlock &block) {
        const auto *verdict = asA<VerdictLine>(block);
        return verdict && verdict->large;
    };
    const auto isTitle = [](const MeasuredBlock &block) {
        const auto *heading = asA<Heading>(block);
        return heading && heading->level == 1;
    };
    const auto end =
        std::find_if(std::ranges::find_if(blocks, isSummary), blocks.end(),
                     [](const MeasuredBlock &block) { return asA<PageBreak>(block) != nullptr; });
    const std::size_t behind = indexOf(end);
    const auto title = std::find_if(end, blocks.end(), isTitle);
    const std::size_t first = indexOf(std::find_if(title, blocks.end(), [&](const MeasuredBlock &block) {
        const auto *heading = asA<Heading>(block);
        return heading && heading->level == 2 && heading->anchor == QLatin1StringView("limits");
    }));
    if (first >= blocks.size() ||
        std::find_if(title + 1, placeOf(blocks, first), isTitle) != placeOf(blocks, first))
        return false;
    const int page = pagesOfBlocks(flow, blocks.size())[behind - 1];
    if (page == 0)
        return false;
    const std::size_t taken = endOfWhatFits(blocks, first, heightsOfBlocks(flow, blocks.size()),
                                            flow.pages()[static_cast<std::size_t>(page) - 1], bottom);
    if (taken == first || taken >= blocks.size()) // something remains behind the break
        return false;
    std::rotate(placeOf(blocks, behind), placeOf(blocks, first), placeOf(blocks, taken));
    return true;
}

/// If the results of one of several tests continue after the page of its head, fills that page with its
/// findings if they fit completely. Returns true if blocks were moved.
bool fillResults(MeasuredBlocks &blocks, const Flow &flow, double bottom) {
    const std::vector<int> pages = pagesOfBlocks(flow, blocks.size());
    const std::vector<double> heights = heightsOfBlocks(flow, blocks.size());
    for (std::size_t head = 0; head + 1 < blocks.size(); ++head) {
        const auto *verdict = asA<VerdictLine>(blocks[head + 1]);
        if (!asA<TestHead>(blocks[head]) || !verdict || verdict->anchor.isEmpty())
            continue;
        std::size_t behind = head + 1;
        while (behind < blocks.size() && !isMark(*blocks[behind].block))
            ++behind;
        const int page = pages[behind - 1];
        std::size_t first = behind;
        while (first < blocks.size() && anchorOf(*blocks[first].block) != verdict->anchor)
            ++first;
        if (page <= pages[head] || first >= blocks.size())
            continue;
        const std::size_t taken = endOfWhatFits(blocks, first, heights,
                                                flow.pages()[static_cast<std::size_t>(page) - 1], bottom, 1);
        if (taken == first)
            continue;
        std::rotate(placeOf(blocks, behind), placeOf(blocks, first), placeOf(blocks, taken));
        return true;
    }
    return false;
}

bool isAnnex(const MeasuredBlock &block) {
    const auto *head = asA<TestHead>(block);
    return head && head->annex;
}

int pagesBeforeAnnex(const MeasuredBlocks &blocks, const Flow &flow) {
    const auto head = static_cast<std::size_t>(std::ranges::find_if(blocks, isAnnex) - blocks.begin());
    return head < blocks.size() ? pagesOfBlocks(flow, blocks.size())[head] - 1 : 0;
}

/// Moves the last section that may go to the annex below its head. Returns true if there was one.
bool moveToAnnex(MeasuredBlocks &blocks) {
    const auto head = static_cast<std::size_t>(std::ranges::find_if(blocks, isAnnex) - blocks.begin());
    for (std::size_t i = head; i-- > 0;) {
        const Heading *heading = sectionHeading(*blocks[i].block);
        if (!heading || !heading->annexFirst)
            continue;
        std::rotate(placeOf(blocks, i), placeOf(blocks, endOfSection(blocks, i)), placeOf(blocks, head + 1));
        return true;
    }
    return false;
}

/// Sets what a block holds smaller and closer, as far as it can be.
template <class Holder>
void setNarrow(Holder &block) {
    if constexpr (requires { block.narrow; })
        block.narrow = true;
    if constexpr (std::is_same_v<Holder, TestHead>) {
        setNarrow(block.left);
        setNarrow(block.right);
    } else if constexpr (std::is_same_v<Holder, SideBySide>) {
        for (auto *side : {&block.left, &block.right}) {
            for (Part &part : *side)
                std::visit([](auto &each) { setNarrow(each); }, part);
        }
    }
}

/// Height of an empty page.
double tallestAt(double bottom) {
    return bottom - topMargin - runningHeadHeight();
}

/// Which strip stands where in a report. Text is measured once, with the widest page numbers; again is
/// measured what names a page, with its number and in the height it had, and what is set narrow in a
/// certificate that is too long.
class Layout {
public:
    Layout(Report report, QSizeF size, const std::stop_token &stop = {})
        : m_report(std::move(report))
        , m_width(size.width() - leftMargin - rightMargin)
        , m_bottom(size.height() - bottomMargin)
        , m_flow(m_bottom) {
        constexpr int widestNumber = 888;
        for (const Block &block : m_report.blocks) {
            if (const QString anchor = anchorOf(block); !anchor.isEmpty())
                m_widest.emplace(anchor, widestNumber);
        }
        m_blocks.reserve(m_report.blocks.size());
        for (Block &block : m_report.blocks) {
            if (stop.stop_requested())
                break;
            measure(m_blocks.emplace_back(MeasuredBlock{std::make_shared<Block>(std::move(block)), {}}),
                    false);
        }
        m_report.blocks = {};
        arrange();
        squeezeParts();
        squeezeEnds();
        putNumbers();
    }

    /// The report without its blocks, which are in another order and may say more: the pages.
    [[nodiscard]] const Report &report() const { return m_report; }
    [[nodiscard]] std::vector<std::shared_ptr<const Block>> blocks() const {
        std::vector<std::shared_ptr<const Block>> result;
        for (const MeasuredBlock &each : m_blocks)
            result.push_back(each.block);
        return result;
    }
    [[nodiscard]] std::vector<PageStrips> takePages() { return m_flow.takePages(); }
    /// Whether each block of the report is set narrow.
    [[nodiscard]] std::vector<bool> narrowness() const {
        std::vector<bool> result;
        for (const MeasuredBlock &each : m_blocks)
            result.push_back(each.narrow);
        return result;
    }

private:
    [[nodiscard]] StripPlaces stripsOf(const std::shared_ptr<const Block> &block, bool narrow) const {
        return placesOf(measured(block, m_width, tallestAt(m_bottom), narrow));
    }

    /// The block, to be changed.
    static Block &own(MeasuredBlock &each) {
        if (each.block.use_count() > 1)
            each.block = std::make_shared<Block>(*each.block);
        return *each.block;
    }

    void measure(MeasuredBlock &each, bool narrow) const {
        if (std::holds_alternative<SideBySide>(*each.block))
            levelColumns(std::get<SideBySide>(own(each)), m_width, tallestAt(m_bottom));
        each.narrow = narrow;
        if (!namesPages(*each.block)) {
            each.strips = stripsOf(each.block, narrow);
            return;
        }
        const auto widest = std::make_shared<Block>(*each.block);
        putPages(*widest, m_widest);
        each.strips = stripsOf(widest, narrow);
    }

    void flow() {
        StripPlaces strips = joined(m_blocks);
        double narrowing = 1;
        bool inAnnex = false;
        for (StripPlace &strip : strips) {
            const auto *block = strip.block < 0 ? nullptr : &m_blocks[static_cast<std::size_t>(strip.block)];
            inAnnex = inAnnex || (block && isAnnex(*block));
            if (block && static_cast<std::size_t>(strip.block) >= m_narrowFrom)
                narrowing = inAnnex ? m_narrowingOfAnnex : m_narrowing;
            strip.gap *= strip.gap < smallestToNarrow ? 1 : block && block->close ? closest : narrowing;
        }
        m_flow = Flow(m_bottom);
        m_flow.fill(strips);
    }

    /// Moves blocks to where they find room; each move may move what follows.
    void arrange() {
        flow();
        if (fillSummary(m_blocks, m_flow, m_bottom))
            flow();
        constexpr int mostMoves = 40;
        for (int i = 0; i < mostMoves; ++i) {
            // Pages are filled once nothing is set closer any more.
            if (!followPages(m_blocks, m_flow) && !moveAllResults(m_blocks, m_flow) && !shorten() &&
                !fillResults(m_blocks, m_flow, m_bottom))
                return;
            flow();
        }
    }

    /// If the certificate has too many pages: narrower gaps, then sections to the annex, then everything
    /// closer, at first behind the pages of heads; if that saves no page, as wide as before. Returns true if
    /// anything changed.
    bool shorten() {
        const int pages = pagesBeforeAnnex(m_blocks, m_flow);
        if (m_report.certificatePages == 0 || pages <= m_report.certificatePages || m_tooLong)
            return false;
        if (m_narrowing == 1) {
            m_narrowing = slightlyNarrower;
        } else if (m_wide.empty() && moveToAnnex(m_blocks)) {
            return true;
        } else if (m_wide.empty()) {
            m_wide = m_blocks;
            m_widePages = pages;
            narrowBlocks(false);
        } else if (m_narrowing > closest) {
            m_narrowing = closest;
        } else if (!m_narrowHeads) {
            m_narrowHeads = true;
            narrowBlocks(true);
        } else {
            m_tooLong = true;
            if (pages < m_widePages)
                return false;
            m_blocks = std::move(m_wide);
            m_narrowing = 1;
        }
        return true;
    }

    /// Sets the blocks of the certificate narrow, those on the page of a head only with `heads`.
    void narrowBlocks(bool heads) {
        const std::vector<int> pages = pagesOfBlocks(m_flow, m_blocks.size());
        std::set<int> ofHeads;
        for (std::size_t i = 0; i < m_blocks.size(); ++i) {
            if (asA<TestHead>(m_blocks[i]))
                ofHeads.insert(pages[i]);
        }
        for (std::size_t i = 0; i + 1 < m_blocks.size() && !isAnnex(m_blocks[i + 1]); ++i) {
            if (heads == ofHeads.contains(pages[i])) {
                std::visit([](auto &block) { setNarrow(block); }, own(m_blocks[i]));
                measure(m_blocks[i], true);
            }
        }
    }

    /// Sets a part about no test alone closer if it then has one page instead of two.
    void squeezeParts() {
        for (std::size_t head = 0; head < m_blocks.size(); ++head) {
            const auto *of = asA<TestHead>(m_blocks[head]);
            if (!of || !of->anchor.isEmpty())
                continue;
            std::size_t end = head;
            while (end < m_blocks.size() && !isMark(*m_blocks[end].block))
                ++end;
            const auto pagesMore = [&] {
                const std::vector<int> pages = pagesOfBlocks(m_flow, m_blocks.size());
                return *std::max_element(pages.begin() + static_cast<std::ptrdiff_t>(head),
                                         pages.begin() + static_cast<std::ptrdiff_t>(end)) -
                       pages[head];
            };
            if (pagesMore() != 1)
                continue;
            const MeasuredBlocks wide(placeOf(m_blocks, head), placeOf(m_blocks, end));
            for (std::size_t i = head; i < end; ++i) {
                std::visit([](auto &block) { setNarrow(block); }, own(m_blocks[i]));
                measure(m_blocks[i], true);
                m_blocks[i].close = true;
            }
            flow();
            if (pagesMore() > 0) {
                std::ranges::copy(wide, placeOf(m_blocks, head));
                flow();
            }
        }
    }

    /// Narrower gaps, if that saves a page of the annex, or the last one of a certificate that would stay too
    /// empty without what the page before it gave.
    void squeezeEnds() {
        const auto squeeze = [&](double &narrowing, std::size_t last, double most) {
            const std::vector<PageStrips> &pages = m_flow.pages();
            if (narrowing < 1 || last == 0 || last >= pages.size() ||
                pages[last - 1].used() + pages[last].used() >= (1 + most) * (m_bottom - pages[last].top()))
                return;
            const std::size_t before = pages.size();
            for (const double factor : {slightlyNarrower, narrowest}) {
                narrowing = factor;
                flow();
                if (m_flow.pages().size() < before)
                    return;
            }
            narrowing = 1;
            flow();
        };
        const auto certificate = static_cast<std::size_t>(pagesBeforeAnnex(m_blocks, m_flow));
        if (certificate > 0)
            squeeze(m_narrowingOfAnnex, m_flow.pages().size() - 1, 1);
        if (m_narrowing == 1)
            m_narrowFrom = lastPart();
        squeeze(m_narrowing, certificate > 0 ? certificate - 1 : m_flow.pages().size() - 1, leastFill);
    }

    /// The block that the last part of the certificate begins with: gaps above it save none of its pages.
    [[nodiscard]] std::size_t lastPart() const {
        std::size_t begin = 0;
        for (std::size_t i = 0; i + 1 < m_blocks.size() && !isAnnex(m_blocks[i + 1]); ++i) {
            if (asA<PageBreak>(m_blocks[i]))
                begin = i + 1;
        }
        return begin;
    }

    void putNumbers() {
        const std::map<QString, int> numbers = anchorPages(m_flow, m_blocks);
        for (MeasuredBlock &each : m_blocks) {
            if (!namesPages(*each.block))
                continue;
            putPages(own(each), numbers);
            each.narrow = each.close;
            StripPlaces strips = stripsOf(each.block, each.narrow);
            for (std::size_t i = 0; i < std::min(strips.size(), each.strips.size()); ++i)
                strips[i].height = each.strips[i].height;
            each.strips = std::move(strips);
        }
        flow();
    }

    Report m_report;
    double m_width;
    double m_bottom;
    MeasuredBlocks m_blocks;
    Flow m_flow;
    double m_narrowing = 1;       ///< factor for the larger gaps of the certificate
    std::size_t m_narrowFrom = 0; ///< first block that it applies to
    double m_narrowingOfAnnex = 1;
    std::map<QString, int> m_widest; ///< page numbers of anchors before they are known
    MeasuredBlocks m_wide;           ///< before anything was set narrow
    int m_widePages = 0;             ///< of the certificate then
    bool m_narrowHeads = false;
    bool m_tooLong = false; ///< whatever is done
};

/// The strips of blocks with what they draw, made again where a page asks for them. They stay until a page
/// after their last one is made: where they stand in memory tells parts apart (Tag).
class DrawnBlocks {
public:
    DrawnBlocks(std::vector<std::shared_ptr<const Block>> blocks, std::vector<bool> narrow, double width,
                double tallest)
        : m_blocks(std::move(blocks))
        , m_narrow(std::move(narrow))
        , m_width(width)
        , m_tallest(tallest) {}

    [[nodiscard]] const Block &block(std::size_t index) const { return *m_blocks[index]; }
    void beginPage() {
        std::erase_if(m_drawn, [this](const auto &each) { return each.second.page < m_page; });
        ++m_page;
    }

    /// Owns what it draws.
    std::function<void(QPainter &, QPointF)> drawing(const StripPlace &place) {
        const auto index = static_cast<std::size_t>(place.owner);
        Drawn &drawn = m_drawn[index];
        drawn.page = m_page;
        if (!drawn.strips)
            drawn.strips = std::make_shared<const Strips>(
                measured(m_blocks[index], m_width, m_tallest, m_narrow[index]));
        const Strip &strip = drawn.strips->at(static_cast<std::size_t>(place.index));
        if (strip.drawOf && place.lowered)
            return strip.drawOf(place.height);
        return [strips = drawn.strips, &strip](QPainter &painter, QPointF at) { strip.draw(painter, at); };
    }

private:
    struct Drawn {
        std::shared_ptr<const Strips> strips;
        std::size_t page = 0; ///< that asked last
    };

    std::vector<std::shared_ptr<const Block>> m_blocks;
    std::vector<bool> m_narrow; ///< by block
    double m_width;
    double m_tallest;
    std::map<std::size_t, Drawn> m_drawn; ///< by block
    std::size_t m_page = 0;
};

/// Makes the pages of a layout.
class PageMaker {
public:
    PageMaker(Layout layout, QSizeF size)
        : m_report(layout.report())
        , m_inTest(inTest(layout.blocks()))
        , m_size(size)
        , m_width(size.width() - leftMargin - rightMargin)
        , m_blocks(layout.blocks(), layout.narrowness(), m_width, tallestAt(size.height() - bottomMargin))
        , m_pages(layout.takePages()) {}

    [[nodiscard]] std::size_t count() const { return m_pages.size(); }

    [[nodiscard]] PrintedPage page(std::size_t index) {
        m_blocks.beginPage();
        const PageStrips &content = m_pages[index];
        // If a table continues, the next page begins with its repeated head, followed by its next row.
        const StripPlace *next = index + 1 < m_pages.size() && m_pages[index + 1].strips.size() > 1
                                     ? &m_pages[index + 1].strips[1]
                                     : nullptr;
        PrintedPage result;
        result.size = m_size;
        if (content.running)
            addRunningHead(result, *content.running);
        addStrips(result, content, next);
        addFooter(result, index + 1, m_pages.size());
        return result;
    }

private:
    static double wideGap(const StripPlace &strip) {
        return strip.section && strip.gap >= sectionGap ? largestGap : strip.gap;
    }

    void addStrips(PrintedPage &page, const PageStrips &content, const StripPlace *next) {
        const double free = m_size.height() - bottomMargin - content.top() - content.used();
        double extra = 0;
        for (const StripPlace &strip : content.strips) {
            if (&strip != &content.strips.front())
                extra += wideGap(strip) - strip.gap;
        }
        const bool wide = extra <= free;
        double y = content.top();
        for (const StripPlace &strip : content.strips) {
            if (&strip != &content.strips.front())
                y += wide ? wideGap(strip) : strip.gap;
            if (strip.drawn)
                page.parts.push_back({{leftMargin, y}, m_blocks.drawing(strip), !strip.link.isEmpty()});
            if (strip.block >= 0)
                addBookmark(page, static_cast<std::size_t>(strip.block), y);
            if (!strip.link.isEmpty())
                page.links.push_back({QRectF(leftMargin, y, m_width, strip.height), strip.link});
            y += strip.height;
        }
        const bool tableGoesOn =
            next && next->head && !content.strips.empty() && content.strips.back().head == next->head;
        if (tableGoesOn) {
            page.parts.push_back(
                {{leftMargin, y}, [width = content.strips.back().closingRule](QPainter &painter, QPointF at) {
                     drawRule(painter, at, width, outerRule);
                 }});
        }
    }

    /// Bookmarks of sections in a test are below the bookmark of the test.
    void addBookmark(PrintedPage &page, std::size_t index, double y) const {
        const Block &block = m_blocks.block(index);
        if (const auto *head = std::get_if<TestHead>(&block))
            page.bookmarks.push_back(
                {0, head->subtitle.isEmpty() || head->annex ? head->title : head->subtitle, y, head->anchor});
        else if (const auto *heading = std::get_if<Heading>(&block); heading && heading->level <= 2)
            page.bookmarks.push_back(
                {m_inTest[index] && heading->level > 1 ? 1 : 0, heading->text, y, heading->anchor});
    }

    /// True for each block that follows the head of a test or a heading of level 1; a page break ends that.
    static std::vector<bool> inTest(const std::vector<std::shared_ptr<const Block>> &blocks) {
        std::vector<bool> result;
        bool within = false;
        for (const auto &block : blocks) {
            if (std::holds_alternative<PageBreak>(*block))
                within = false;
            else if (const auto *heading = std::get_if<Heading>(block.get());
                     std::holds_alternative<TestHead>(*block) || (heading && heading->level == 1))
                within = true;
            result.push_back(within);
        }
        return result;
    }

    void addRunningHead(PrintedPage &page, const RunningHead &running) const {
        const TextBlock right = elided(running.right, 0.7 * m_width);
        const TextBlock left = elided(running.left, m_width - right.width() - 5 * mm);
        page.parts.push_back({{leftMargin, topMargin}, [=, width = m_width](QPainter &painter, QPointF at) {
                                  left.draw(painter, at);
                                  right.draw(painter, at, TextAlignment::right, width);
                                  drawRule(painter, at + QPointF(0, left.lineHeight() + runningRule), width,
                                           headRule, ruleGrey);
                              }});
    }

    void addFooter(PrintedPage &page, std::size_t number, std::size_t count) const {
        QString pageNumber = m_report.footerRight;
        pageNumber.replace(QLatin1String("%1"), QString::number(number));
        pageNumber.replace(QLatin1String("%2"), QString::number(count));
        const TextBlock centre = elided(m_report.footerCentre, m_width / 2);
        const TextBlock right(pageNumber, runningStyle);
        const double room = (m_width - centre.width()) / 2 - 3 * mm;
        TextBlock left(m_report.footerLeft, runningStyle, room); // long numbers whole, if they can be
        constexpr std::size_t mostLines = 3;
        if (left.lineCount() > mostLines)
            left = elided(m_report.footerLeft, room);
        page.parts.push_back(
            {{leftMargin, m_size.height() - footerRule}, [=, width = m_width](QPainter &painter, QPointF at) {
                 drawRule(painter, at, width, headRule, ruleGrey);
                 const QPointF line = at + QPointF(0, footerText);
                 left.draw(painter, line);
                 centre.draw(painter, line, TextAlignment::centre, width);
                 right.draw(painter, line, TextAlignment::right, width);
             }});
    }

    Report m_report; ///< without its blocks
    std::vector<bool> m_inTest;
    QSizeF m_size;
    double m_width;
    DrawnBlocks m_blocks;
    std::vector<PageStrips> m_pages;
};

} // namespace

Report arrangedForPages(const Report &report) {
    const Layout layout(report, sizeOf(report.paper));
    Report result = layout.report();
    for (const auto &block : layout.blocks())
        result.blocks.push_back(*block);
    return result;
}

LaidOutReport::LaidOutReport(Report report, const std::stop_token &stop) {
    const QSizeF size = sizeOf(report.paper);
    const auto maker = std::make_shared<PageMaker>(Layout(std::move(report), size, stop), size);
    m_count = maker->count();
    m_page = [maker](std::size_t index) { return maker->page(index); };
}

Pages layoutPages(const Report &report, const std::stop_token &stop) {
    LaidOutReport laidOut(report, stop);
    Pages pages;
    for (std::size_t i = 0; i < laidOut.pageCount(); ++i)
        pages.push_back(laidOut.page(i));
    return pages;
}

Pages firstPages(const Report &report) {
    constexpr std::size_t most = 16; // more than a page holds
    Report first = report;
    first.blocks.resize(std::min(most, first.blocks.size()));
    const auto isBreak = [](const Block &block) { return std::holds_alternative<PageBreak>(block); };
    first.blocks.erase(std::ranges::find_if(first.blocks, isBreak), first.blocks.end());
    first.footerRight.replace(QLatin1String("%2"), QStringLiteral("–"));
    return layoutPages(first);
}

void drawPage(QPainter &painter, const PrintedPage &page) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    for (const PagePart &part : page.parts) {
        const LinkTag link(part.linked);
        part.draw(painter, part.place);
    }
    painter.restore();
}

} // namespace palmer
