#include "message_table.hpp"

#include "flat_fields.hpp"
#include <jauscat/net/now.hpp>
#include <jauscat/text/diagnosis_text.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

namespace jauscat::net::live {

namespace {

std::string id_text(std::uint64_t id, bool is_sae) {
    const auto octet = [&](unsigned shift) { return std::to_string(id >> shift & 255U); };
    if (is_sae) return std::to_string(id >> 16U & 0xFFFFU) + '.' + octet(8) + '.' + octet(0);
    return octet(24) + '.' + octet(16) + '.' + octet(8) + '.' + octet(0);
}
double rounded(double value, double parts) { return std::round(value * parts) / parts; }

constexpr std::array way_names{"received", "sent", "seen"};
constexpr std::array acknowledgement_names{"", "request", "nak", "ack"};
constexpr std::uint8_t wants_acknowledgement = 1;

} // namespace

void message_table::add(const net::detail::live_sample& sample) {
    const auto acknowledgement =
        sample.acknowledgement == wants_acknowledgement ? std::uint8_t{} : sample.acknowledgement;
    const key of{sample.from, sample.to, sample.code, sample.way, acknowledgement, sample.is_sae};
    auto found = rows_.find(of);
    if (found == rows_.end()) {
        if (rows_.size() == live_server::max_rows) {
            ++lost_;
            return;
        }
        found = rows_.try_emplace(of).first;
        found->second.id = by_id_.size() + 1;
        by_id_.push_back(&found->second);
    }
    row& one = found->second;
    // Most messages are a tenth of what fits.
    std::memcpy(static_cast<void*>(&one.newest), &sample, offsetof(net::detail::live_sample, bytes) + sample.kept);
    ++one.count;
    one.is_changed = true;
}

void message_table::resume() {
    times_.fill(now() - begin_);
    for (auto& [of, one] : rows_) one.counts.fill(one.count);
}

void message_table::end_update() {
    ++update_;
    const auto place = static_cast<std::size_t>(update_ % rate_updates);
    times_[place] = now() - begin_;
    for (auto& [of, one] : rows_) {
        if (one.is_changed || one.has_rate) write(of, one);
        one.counts[place] = one.count;
    }
}

void message_table::write(const key& of, row& one) const {
    // The oldest update that is remembered, or the first one.
    const auto oldest = static_cast<std::size_t>((update_ + 1) % rate_updates);
    const std::chrono::duration<double> passed =
        times_[static_cast<std::size_t>(update_ % rate_updates)] - times_[oldest];
    const auto rate = passed.count() > 0 ? static_cast<double>(one.count - one.counts[oldest]) / passed.count() : 0.0;
    const auto shown = rounded(rate, 10);
    one.has_rate = rate > 0;
    if (!one.is_changed && shown == one.rate) return;
    one.rate = shown;
    one.changed = update_;
    if (std::exchange(one.is_changed, false)) decode(of, one);
    json made{{"id", one.id}, {"count", one.count}, {"rate", one.rate}};
    one.text = made.dump();
    one.text.back() = ',';
    one.text += one.message;
}

void message_table::decode(const key& of, row& one) const {
    const auto& sample = one.newest;
    const auto* const list = of.is_sae ? sae_messages_ : messages_;
    const auto* const type = list != nullptr ? list->find(of.code) : nullptr;
    json made{{"generation", of.is_sae ? "sae" : "ra"},
              {"way", way_names[std::min<std::size_t>(of.way, way_names.size() - 1)]},
              {"code", of.is_sae && of.code == 0 ? std::string{} : text::hex_word(of.code)},
              {"name", type != nullptr ? std::string{type->name()} : std::string{}},
              {"from", id_text(of.from, of.is_sae)},
              {"to", id_text(of.to, of.is_sae)},
              {"at", rounded(std::chrono::duration<double>{sample.at - begin_}.count(), 1000)},
              {"size", sample.size},
              {"hex", text::detail::plain_hex(std::span{sample.bytes}.first(sample.kept))}};
    if (sample.acknowledgement != 0) made["acknowledgement"] = acknowledgement_names[sample.acknowledgement % 4];
    if (sample.kept < sample.size) made["cut"] = true;
    if (type != nullptr && sample.has_body) {
        const auto body = std::span{sample.bytes}.subspan(sample.body_begin, sample.body_end - sample.body_begin);
        if (const auto message = type->decode(body, wire::tolerate_values)) {
            auto fields = flatten(*message);
            made["fields"] = std::move(fields.values);
            for (const auto& [path, unit] : fields.units.items()) {
                if (one.units.contains(path)) continue;
                one.units[path] = unit;
                one.units_changed = update_;
            }
        } else {
            made["error"] = text::to_text(message.error());
        }
    }
    one.message = made.dump(-1, ' ', false, json::error_handler_t::replace).substr(1);
    one.message.pop_back(); // the braces
}

std::string message_table::rows_since(std::uint64_t seen) const {
    std::string all;
    for (const auto* const one : by_id_) {
        if (one->changed <= seen) continue;
        all += all.empty() ? '[' : ',';
        all += one->text;
        if (one->units_changed > seen) (all += ",\"units\":") += one->units.dump();
        all += '}';
    }
    if (!all.empty()) all += ']';
    return all;
}

} // namespace jauscat::net::live
