#include "simulation/dictionary_judge.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace simulation {
namespace {

namespace hilscher = jauscat::hilscher;
namespace wire = jauscat::wire;
using bridging::creation_errc;
using ethercat::abort_code;

constexpr std::array names{"joint", "set_wrench_effort", "report", "query of all"};

std::vector<std::vector<bridging::sub_object>> some_entries(generator& random) {
    std::vector<std::vector<bridging::sub_object>> made(2 + random.below(4));
    for (auto& each : made) {
        const bool is_whole = random.below(2) == 0; // all subindices from 1
        std::uint8_t subindex = 0;
        for (auto left = random.below(6); left != 0; --left) {
            subindex = static_cast<std::uint8_t>(subindex + (is_whole ? 1 : 1 + random.below(3)));
            const auto size = random.below(4) == 0 ? 0x1FFE + random.below(5) : 1 + random.below(12);
            each.push_back({.subindex = subindex,
                            .name = names[random.below(names.size())],
                            .max_size = static_cast<std::uint16_t>(size),
                            .readable = random.below(3) != 0,
                            .writable = random.below(3) != 0});
        }
    }
    return made;
}

std::vector<bridging::object_description> some_objects(generator& random,
                                                       const std::vector<std::vector<bridging::sub_object>>& entries) {
    std::vector<bridging::object_description> made;
    std::uint16_t index = 0x3000;
    for (const auto& each : entries) {
        index = static_cast<std::uint16_t>(index + 1 + random.below(3));
        made.push_back({.index = index,
                        .name = names[random.below(names.size())],
                        .exact_size = random.below(3) == 0,
                        .entries = each});
    }
    std::swap(made.front(), made[random.below(made.size())]); // in any order
    return made;
}

} // namespace

dictionary_judge::dictionary_judge(world& w)
    : world_{w},
      number_{w.add("object dictionary")},
      random_{w.stream(1011)},
      entries_{some_entries(random_)},
      objects_{some_objects(random_, entries_)},
      up_to_largest_{objects_, *this, bridging::size_rule::up_to_largest},
      exact_{objects_, *this, bridging::size_rule::exact} {}

void dictionary_judge::start() {
    create();
    world_.in(std::chrono::milliseconds{10}, *this, 0);
}

void dictionary_judge::on_event(std::uint8_t, std::uint32_t) {
    world_.in(random_.between(std::chrono::milliseconds{20}, std::chrono::milliseconds{500}), *this, 0);
    const bool is_exact = random_.below(2) == 0;
    look(is_exact ? exact_ : up_to_largest_, is_exact);
    if (random_.below(10) == 0) create();
}

abort_code dictionary_judge::write(std::uint16_t, std::uint8_t, std::span<const std::byte> data) noexcept {
    was_asked_ = true;
    size_ = data.size();
    return refuses_;
}

ethercat::object_read dictionary_judge::read(std::uint16_t, std::uint8_t, std::span<std::byte> out) noexcept {
    was_asked_ = true;
    return {.error = refuses_, .size = refuses_ == abort_code::none ? std::min(size_, out.size()) : 0};
}

// ---------------------------------------------------------------------------------------------------- accesses

const bridging::object_description* dictionary_judge::known(std::uint16_t index) const {
    for (const auto& each : objects_)
        if (each.index == index) return &each;
    return nullptr;
}

const bridging::sub_object* dictionary_judge::entry_of(const bridging::object_description& object,
                                                       std::uint8_t subindex) {
    for (const auto& each : object.entries)
        if (each.subindex == subindex) return &each;
    return nullptr;
}

// One that there is, or one beside it.
std::uint16_t dictionary_judge::some_index() {
    const auto& one = objects_[random_.below(objects_.size())];
    return static_cast<std::uint16_t>(random_.below(4) == 0 ? one.index - 1 + random_.below(3) : one.index);
}

void dictionary_judge::look(bridging::listed_objects& at, bool is_exact) {
    for (int i = 0; i != 8; ++i) {
        const auto index = some_index();
        const auto subindex = static_cast<std::uint8_t>(random_.below(12));
        was_asked_ = false;
        refuses_ = random_.below(4) == 0 ? abort_code::device_state : abort_code::none;
        world_.compares(comparison::dictionary);
        look_at_read(at, is_exact, index, subindex);
        was_asked_ = false;
        look_at_write(at, is_exact, index, subindex);
        look_at_descriptions(at, is_exact, index, subindex);
    }
    std::vector<std::uint16_t> all;
    for (const auto& each : objects_) all.push_back(each.index);
    std::ranges::sort(all);
    std::uint16_t last = 0;
    for (const auto each : all) {
        says(at.next_index(last) == each, "the next index", at.next_index(last));
        last = each;
    }
    says(at.next_index(last) == 0, "no index behind the last one", at.next_index(last));
}

void dictionary_judge::look_at_read(bridging::listed_objects& at, bool is_exact, std::uint16_t index,
                                    std::uint8_t subindex) {
    std::vector<std::byte> space(std::size_t{0x2100});
    const auto* const object = known(index);
    const auto* const entry = object == nullptr ? nullptr : entry_of(*object, subindex);
    const std::size_t most = entry == nullptr ? 1 : entry->max_size;
    size_ = most - 1 + random_.below(3);
    const auto got = at.read(index, subindex, space);
    const auto refuses = [&](abort_code why) {
        says(got.error == why && !was_asked_, "a read that is refused", static_cast<std::uint32_t>(got.error));
    };
    if (object == nullptr) return refuses(abort_code::no_object);
    if (subindex == 0) {
        const auto highest = object->entries.empty() ? 0 : object->entries.back().subindex;
        says(got.error == abort_code::none && got.size == 1 && space[0] == static_cast<std::byte>(highest),
             "the highest subindex", std::to_integer<unsigned>(space[0]));
        says(at.read(index, 0, {}).error == abort_code::exceeds_mailbox, "no place for it", 0);
        return;
    }
    if (entry == nullptr) return refuses(abort_code::no_subindex);
    if (!entry->readable) return refuses(abort_code::write_only);
    const bool must_be_exact = is_exact || object->exact_size;
    const bool fits = must_be_exact ? size_ == most : size_ <= most;
    const auto expected = refuses_ != abort_code::none ? refuses_
                          : fits                       ? abort_code::none
                                                       : abort_code::length_mismatch;
    says(was_asked_ && got.error == expected, "a read of the application's", static_cast<std::uint32_t>(got.error));
    says(expected != abort_code::none || got.size == size_, "as many bytes as there are", got.size);
}

void dictionary_judge::look_at_write(bridging::listed_objects& at, bool is_exact, std::uint16_t index,
                                     std::uint8_t subindex) {
    const auto* const object = known(index);
    const auto* const entry = object == nullptr ? nullptr : entry_of(*object, subindex);
    const std::size_t most = entry == nullptr ? 1 : entry->max_size;
    const std::vector<std::byte> data(most - 1 + random_.below(3));
    const auto got = at.write(index, subindex, data);
    const auto refuses = [&](abort_code why) {
        says(got == why && !was_asked_, "a write that is refused", static_cast<std::uint32_t>(got));
    };
    if (object == nullptr) return refuses(abort_code::no_object);
    if (subindex == 0) return refuses(abort_code::read_only);
    if (entry == nullptr) return refuses(abort_code::no_subindex);
    if (!entry->writable) return refuses(abort_code::read_only);
    const bool must_be_exact = is_exact || object->exact_size;
    if (must_be_exact && data.size() != most) return refuses(abort_code::length_mismatch);
    if (data.size() > most) return refuses(abort_code::length_too_high);
    says(was_asked_ && got == refuses_ && size_ == data.size(), "a write to the application",
         static_cast<std::uint32_t>(got));
}

void dictionary_judge::look_at_descriptions(const bridging::listed_objects& at, bool is_exact, std::uint16_t index,
                                            std::uint8_t subindex) {
    const auto* const object = known(index);
    const auto of_object = at.describe(index);
    const auto of_entry = at.describe(index, subindex);
    says(of_object.has_value() == (object != nullptr), "a description of each object", index);
    if (object == nullptr || !of_object) return says(!of_entry, "no description of an entry of none", index);
    const std::size_t highest = object->entries.empty() ? 0 : object->entries.back().subindex;
    const bool must_be_exact = is_exact || object->exact_size;
    const bool is_whole = object->entries.size() == highest;
    says(of_object->highest_subindex == highest && of_object->code == ethercat::object_code::record &&
             of_object->name == object->name && of_object->complete_access == (is_whole && must_be_exact),
         "the description of an object", index);
    const auto* const entry = entry_of(*object, subindex);
    says(of_entry.has_value() == (subindex == 0 || entry != nullptr), "a description of each entry", subindex);
    if (!of_entry) return;
    const auto& access = of_entry->access;
    if (subindex == 0)
        return says(of_entry->bits == 8 && ethercat::is_readable(access) && !ethercat::is_writable(access),
                    "the description of the highest subindex", of_entry->bits);
    if (entry == nullptr) return;
    const auto bits = std::min<std::size_t>(entry->max_size * std::size_t{8}, 0xFFFF);
    says(of_entry->bits == bits && of_entry->data_type == bridging::octet_string_type &&
             of_entry->name == entry->name && ethercat::is_readable(access) == entry->readable &&
             ethercat::is_writable(access) == entry->writable,
         "the description of an entry", subindex);
}

// ---------------------------------------------------------------------------------------------------- creation

void dictionary_judge::create() {
    const hilscher::packet_header given{
        .ul_dest = 0x20 + random_.below(4), .ul_src = random_.below(1000), .ul_id = random_.below(1000)};
    for (const auto& object : objects_) {
        const bridging::object_creation creation{object, given};
        says(creation.size() == 1 + object.entries.size(), "a packet for each part of an object", creation.size());
        for (std::size_t number = 0; number != creation.size(); ++number) {
            world_.compares(comparison::creation);
            std::array<std::byte, 256> space{};
            const auto packet = creation.packet(number, space);
            says(static_cast<bool>(packet), "a packet", number);
            if (!packet) return;
            says(!creation.packet(number, std::span{space}.first(20)), "no packet without a place for it", number);
            look_at_request(object, number, *packet, given);
            answer(creation, object, number, given.ul_id + static_cast<std::uint32_t>(number));
        }
    }
    std::vector<std::string_view> texts;
    for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(creation_errc::refused) + 1; ++i) {
        const auto text = bridging::describe(static_cast<creation_errc>(i));
        says(!text.empty() && std::ranges::find(texts, text) == texts.end(), "a text of its own for each result", i);
        texts.push_back(text);
    }
}

// As a slave's stack reads it.
void dictionary_judge::look_at_request(const bridging::object_description& object, std::size_t number,
                                       std::span<const std::byte> packet, const hilscher::packet_header& given) {
    const auto is_head_right = [&](const auto& request, std::size_t body) {
        const auto& head = request.head;
        return head.ul_dest == given.ul_dest && head.ul_src == given.ul_src && head.ul_id == given.ul_id + number &&
               head.ul_len == packet.size() - 40 && request.ul_total_data_bytes == packet.size() - 40 - body;
    };
    constexpr std::size_t body_of_object = 20, body_of_subobject = 17;
    if (number == 0) {
        hilscher::od_create_object_request is{};
        const bool is_one = static_cast<bool>(wire::decode(is, packet));
        says(is_one && is_head_right(is, body_of_object) &&
                 is.head.ul_cmd == hilscher::packet_command::od_create_object_req,
             "a packet that creates an object", is.head.ul_len);
        const auto highest = object.entries.empty() ? std::uint8_t{} : object.entries.back().subindex;
        says(is.us_index == object.index && is.b_max_num_of_sub_objs == highest && is.name == object.name &&
                 is.b_object_code == hilscher::od_object_code::record &&
                 is.us_access_flags.test(hilscher::od_object_flag::create_subindex_0),
             "the object of the list", is.us_index);
        return;
    }
    const auto& entry = object.entries[number - 1];
    hilscher::od_create_subobject_request is{};
    const bool is_one = static_cast<bool>(wire::decode(is, packet));
    says(is_one && is_head_right(is, body_of_subobject) &&
             is.head.ul_cmd == hilscher::packet_command::od_create_subobject_req,
         "a packet that creates a subobject", is.head.ul_len);
    says(is.us_index == object.index && is.b_sub_index == entry.subindex && is.name == entry.name &&
             is.ul_max_field_units == entry.max_size && is.variable_size == !object.exact_size &&
             is.us_datatype == hilscher::od_data_type::octet_string,
         "the subobject of the list", is.b_sub_index);
    using enum hilscher::od_access;
    const auto all = [&](bool allowed, auto... rights) {
        return ((is.us_access_rights.test(rights) == allowed) && ...);
    };
    says(all(entry.readable, read_pre_op, read_safe_op, read_operational) &&
             all(entry.writable, write_pre_op, write_safe_op, write_operational) && all(false, read_init, write_init) &&
             is.b_indication_flags.test(hilscher::od_indication::on_read) == entry.readable &&
             is.b_indication_flags.test(hilscher::od_indication::on_write) == entry.writable,
         "the rights of the list", is.b_sub_index);
}

// A stack that confirms, refuses, confirms something else or is interrupted.
void dictionary_judge::answer(const bridging::object_creation& creation, const bridging::object_description& object,
                              std::size_t number, std::uint32_t id) {
    std::array<std::byte, 64> space{};
    const auto status = random_.below(4) == 0 ? hilscher::od_status::object_exists : hilscher::od_status::ok;
    const auto other = random_.below(8); // 0 to 3: what is another's
    const auto index = static_cast<std::uint16_t>(object.index + (other == 0 ? 1 : 0));
    std::span<std::byte> packet;
    const auto put = [&](auto confirmation) {
        confirmation.head.ul_id = id + (other == 1 ? 1 : 0);
        confirmation.head.ul_sta = static_cast<hilscher::packet_status>(status);
        confirmation.us_index = index;
        if (other == 2) confirmation.head.ul_cmd = hilscher::packet_command::sdo_upload_cnf;
        if (const auto made = wire::encode(confirmation, space)) packet = *made;
    };
    bool is_of_other = other < 3;
    if (number == 0) {
        put(hilscher::od_create_object_confirmation{});
    } else {
        hilscher::od_create_subobject_confirmation made{};
        made.b_sub_index = static_cast<std::uint8_t>(object.entries[number - 1].subindex + (other == 3 ? 1 : 0));
        is_of_other = other <= 3;
        put(made);
    }
    const bool is_cut = random_.below(6) == 0;
    if (is_cut) packet = packet.first(random_.below(packet.size()));
    constexpr std::size_t header = 40;
    const bool is_wrong_head = other == 1 || other == 2;
    const auto got = creation.answer(number, packet);
    const auto expected = is_cut && packet.size() < header    ? creation_errc::truncated
                          : is_wrong_head                     ? creation_errc::not_an_answer
                          : status != hilscher::od_status::ok ? creation_errc::refused
                          : is_cut                            ? creation_errc::truncated
                          : is_of_other                       ? creation_errc::not_an_answer
                                                              : creation_errc::ok;
    says(got.error == expected, "the result of a packet", static_cast<std::uint8_t>(got.error));
    says(expected != creation_errc::refused || got.status == status, "the status of a refusal",
         static_cast<std::uint32_t>(got.status));
}

void dictionary_judge::says(bool is_right, const char* expected, std::uint64_t found) {
    if (is_right) return;
    world_.breaks({.point = contract::s7, .who = number_, .expected = expected, .found = std::to_string(found)});
}

} // namespace simulation
