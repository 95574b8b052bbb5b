// The functions of slave_mailbox.
#pragma once
#include <jauscat/ethercat/slave/slave_mailbox.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_mailbox::slave_mailbox(const slave_description& description, object_dictionary objects,
                                              const coe_options& options) noexcept
    : out_start_{description.mailbox_out_offset},
      out_size_{description.mailbox_out_size},
      in_start_{description.mailbox_in_offset},
      in_size_{description.mailbox_in_size},
      delay_{options.answer_delay},
      coe_{objects, options} {}

JAUSCAT_FUNCTION void slave_mailbox::power_on(esc_memory& memory) noexcept {
    forget(memory);
    coe_.power_on();
}

JAUSCAT_FUNCTION void slave_mailbox::forget(esc_memory& memory) noexcept {
    last_counter_ = sent_counter_ = 0;
    replied_ = waiting_ = continued_ = going_back_ = false;
    waiting_emergencies_ = 0;
    coe_.forget_transfer();
    if (!has_mailbox()) return;
    for (const auto n : {manager_numbers::mailbox_out, manager_numbers::mailbox_in})
        if (memory.manager(n).full) memory.set_full(n, false);
}

JAUSCAT_FUNCTION bool slave_mailbox::is_configured(esc_memory& memory) const noexcept {
    if (!has_mailbox()) return true;
    const auto matches = [&memory](const sync_manager& sm, std::uint16_t start, std::uint16_t length,
                                   sync_manager_direction direction) {
        return sm.enable && sm.mode == sync_manager_mode::mailbox && sm.direction == direction && sm.start == start &&
               sm.length == length && length <= max_mailbox_size && memory.area(sm).size() >= min_mailbox_size;
    };
    return matches(memory.manager(manager_numbers::mailbox_out), out_start_, out_size_,
                   sync_manager_direction::master_writes) &&
           matches(memory.manager(manager_numbers::mailbox_in), in_start_, in_size_,
                   sync_manager_direction::master_reads);
}

JAUSCAT_FUNCTION bool slave_mailbox::send_emergency(const coe_emergency& what) noexcept {
    if (!has_mailbox() || waiting_emergencies_ == max_emergencies) return false;
    emergencies_[waiting_emergencies_++] = what;
    return true;
}

JAUSCAT_FUNCTION void slave_mailbox::work(esc_memory& memory) noexcept {
    if (!has_mailbox()) return;
    const auto in = memory.manager(manager_numbers::mailbox_in);
    // Checked before PRE-OP, but a master may have changed the SyncManagers since: it then gets no answer.
    const bool configured = is_configured(memory);
    if (in.repeat_request != in.repeat_acknowledge) {
        if (replied_ && configured) repeat(memory, in);
        memory.acknowledge_repeat(manager_numbers::mailbox_in);
    }
    const auto out = memory.manager(manager_numbers::mailbox_out);
    if (memory.manager(manager_numbers::mailbox_in).full) return; // an answer needs an empty mailbox first
    if (out.full) {
        if (!waiting_) waited_ = 0;
        waiting_ = waited_++ != delay_;
        if (waiting_) return;
        going_back_ = continued_ = false;
        if (configured) answer(memory, memory.area(out), memory.area(in));
        memory.set_full(manager_numbers::mailbox_out, false);
    } else if (configured && going_back_) {
        exchange(memory, in);
        going_back_ = false;
    } else if (configured && waiting_emergencies_ != 0) {
        put_emergency(memory, memory.area(in));
    } else if (configured && coe_.has_more()) {
        go_on(memory, memory.area(in));
    }
}

JAUSCAT_FUNCTION void slave_mailbox::repeat(esc_memory& memory, const sync_manager& in) noexcept {
    if (!in.full) return memory.set_full(manager_numbers::mailbox_in, true);
    if (!continued_ || going_back_) return;
    exchange(memory, in);
    going_back_ = true;
}

JAUSCAT_FUNCTION void slave_mailbox::exchange(esc_memory& memory, const sync_manager& in) noexcept {
    const auto area = memory.area(in);
    std::ranges::swap_ranges(area, std::span{before_}.first(area.size()));
    memory.set_full(manager_numbers::mailbox_in, true);
}

JAUSCAT_FUNCTION void slave_mailbox::answer(esc_memory& memory, std::span<const std::byte> request,
                                            std::span<std::byte> reply) noexcept {
    mailbox_header header{};
    const auto used = wire::decode_prefix(header, request);
    if (header.counter != 0 && header.counter == last_counter_) return; // the master repeats itself
    last_counter_ = header.counter;
    if (header.type == mailbox_type::error) return;

    const auto body = request.subspan(*used);
    const auto room = reply.subspan(*used);
    coe_answer answer{};
    if (header.length > body.size()) {
        answer.error = mailbox_error_code::invalid_size;
    } else if (header.type != mailbox_type::coe) {
        answer.error = mailbox_error_code::unsupported_protocol;
    } else {
        answer = coe_.answer(body.first(header.length), room);
    }
    if (answer.error != mailbox_error_code::none) {
        header.type = mailbox_type::error;
        answer.size = wire::encode(mailbox_error_reply{1, answer.error}, room)->size();
    }
    // An answer has its request's counter, but never that of the message before it.
    if (header.counter != 0 && header.counter == sent_counter_) header.counter = after(header.counter);
    if (answer.size != 0) put(memory, header, answer.size, reply);
}

inline void slave_mailbox::put_next(esc_memory& memory, std::span<std::byte> reply, auto&& put_content) noexcept {
    std::ranges::copy(reply, before_.begin());
    continued_ = replied_; // only a message of ours can go back
    const auto size = put_content(reply.subspan(wire::max_size<mailbox_header>));
    put(memory, {.type = mailbox_type::coe, .counter = after(sent_counter_)}, size, reply);
}

JAUSCAT_FUNCTION void slave_mailbox::go_on(esc_memory& memory, std::span<std::byte> reply) noexcept {
    put_next(memory, reply, [this](std::span<std::byte> room) { return coe_.next(room).size; });
}

JAUSCAT_FUNCTION void slave_mailbox::put_emergency(esc_memory& memory, std::span<std::byte> reply) noexcept {
    put_next(memory, reply, [this](std::span<std::byte> room) {
        const auto header = wire::encode(coe_header{.service = coe_service::emergency}, room)->size();
        return header + wire::encode(emergencies_.front(), room.subspan(header))->size();
    });
    std::rotate(emergencies_.begin(), emergencies_.begin() + 1, emergencies_.end()); // clang 14 has no ranges::rotate
    --waiting_emergencies_;
}

JAUSCAT_FUNCTION void slave_mailbox::put(esc_memory& memory, mailbox_header header, std::size_t size,
                                         std::span<std::byte> reply) noexcept {
    header.length = static_cast<std::uint16_t>(size);
    header.address = 0;
    static_cast<void>(wire::encode(header, reply));
    sent_counter_ = header.counter;
    replied_ = true;
    memory.set_full(manager_numbers::mailbox_in, true);
}

} // namespace jauscat::ethercat
