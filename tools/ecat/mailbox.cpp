#include "ecat/mailbox.hpp"

#include "ecat/sii.hpp"
#include "ecat/value.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/mailbox_session.hpp>
#include <jauscat/ethercat/master/object_descriptions.hpp>
#include <jauscat/ethercat/master/sdo_information.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/master_error_text.hpp>

#include <array>
#include <string_view>
#include <unistd.h>

namespace ecat {

namespace registers = ethercat::esc_registers;
using ethercat::al_state;
using ethercat::master_errc;

std::string reason_text(const ethercat::master_error& error) {
    using namespace std::literals;
    if (error.code == master_errc::sdo_abort && error.abort != ethercat::abort_code::none)
        return "abort code " + hex(static_cast<std::uint32_t>(error.abort), 8) + ": " +
               std::string{describe(error.abort)};
    return jauscat::text::explain(error);
}

void set_up_mailbox(ring& on, std::uint16_t position, const ethercat::sii_mailbox& mailbox) {
    using namespace ethercat;
    const auto manager = [](std::uint16_t start, std::uint16_t length, sync_manager_direction direction) {
        return sync_manager{.start = start,
                            .length = length,
                            .mode = sync_manager_mode::mailbox,
                            .direction = direction,
                            .pdi_interrupt = true,
                            .enable = true};
    };
    const auto is_usable = [](std::uint16_t size) { return size >= min_mailbox_size && size <= max_mailbox_size; };
    if (!is_usable(mailbox.receive_size) || !is_usable(mailbox.send_size))
        throw failure{on.name_of(position) + ": the SII states mailboxes of " + std::to_string(mailbox.receive_size) +
                      " and " + std::to_string(mailbox.send_size) + " bytes: expected 24 to 1486"};
    on.write(position, registers::mailbox_managers, {}); // they can be changed while they are off
    on.write(position, registers::mailbox_managers,
             {.out = manager(mailbox.receive_offset, mailbox.receive_size, sync_manager_direction::master_writes),
              .in = manager(mailbox.send_offset, mailbox.send_size, sync_manager_direction::master_reads)});
}

bool has_coe(ring& on, std::uint16_t position) {
    sii_reader reader{on, position};
    const auto mailbox = reader.read<ethercat::sii_mailbox>(ethercat::sii_words::mailbox);
    return mailbox.coe && mailbox.receive_size != 0;
}

struct coe_mailbox::state {
    ring& on;
    std::uint16_t position;
    ethercat::slave_record record{};
    std::optional<bytes> managers_before{}; // of a slave that was in INIT
    bool has_no_descriptions{};

    /// Runs one session, and prints the emergencies that came meanwhile; throws `coe_failure`.
    template <class Protocol> std::size_t run(const Protocol& protocol, const std::string& what) {
        const notes_emergencies at_the_end{*this};
        const ethercat::master_config config{};
        ethercat::mailbox_session<Protocol> session;
        session.begin(record, protocol);
        std::array<std::byte, ethercat::max_frame_size> frame{};
        const auto fail = [&](const ethercat::master_error& why) {
            throw coe_failure{on.name_of(position) + ": " + what + ": " + reason_text(why), why};
        };
        for (unsigned losses = 0;;) {
            ethercat::frame_builder builder{frame};
            session.request(builder);
            const auto built = builder.finish();
            if (!built) fail({.code = master_errc::no_space});
            auto size = built->size();
            if (!on.try_exchange_at(position, frame, size, on.options().frame_timeout)) {
                if (++losses > on.options().retries) fail(session.cancel({.code = master_errc::no_reply}));
                // What is not harmless twice waits until the lost frame cannot arrive any more.
                if (!session.is_repeatable()) ::usleep(20'000);
                session.lost();
                continue;
            }
            ethercat::frame_view view;
            static_cast<void>(view.parse(std::span<const std::byte>{frame}.first(size)));
            const std::array replies{*view.begin()};
            const auto next = session.reply(replies, jauscat::net::now(), config);
            if (next == ethercat::progress::done) break;
            if (stop_requested()) {
                static_cast<void>(session.cancel({.code = master_errc::timeout}));
                throw failure{"interrupted"};
            }
            if (next == ethercat::progress::wait) ::usleep(50);
        }
        if (!session.result()) fail(session.result().error());
        return *session.result();
    }

    struct notes_emergencies {
        state& of;
        ~notes_emergencies() { of.note_emergencies(); }
    };
    void note_emergencies() {
        for (const auto& each : record.emergencies.kept())
            note(on.name_of(position) + ": emergency: error code " + hex(each.error_code, 4) + ", error register " +
                 hex(each.error_register, 2) + ", data " + jauscat::text::hex(each.data));
        if (record.emergencies.overflow()) note(on.name_of(position) + ": it has sent more emergencies before these");
        record.emergencies.clear();
    }

    void open() {
        const auto al = on.read(position, registers::al_status);
        if (al.state == al_state::boot)
            throw failure{on.name_of(position) + ": it is in BOOT, where it has no objects: take it to INIT first"};
        ethercat::sii_mailbox mailbox;
        {
            sii_reader reader{on, position};
            mailbox = reader.read<ethercat::sii_mailbox>(ethercat::sii_words::mailbox);
        }
        if (mailbox.receive_size == 0 || !mailbox.coe)
            throw failure{on.name_of(position) + ": its SII states no CoE mailbox: it has no objects"};
        if (al.state == al_state::init) {
            managers_before = on.read(position, registers::mailbox_managers.address, registers::mailbox_managers.size);
            set_up_mailbox(on, position, mailbox);
            on.change_state(position, al_state::pre_op);
        }
        const auto is = on.read(position, registers::mailbox_managers);
        if (!is.out.enable || !is.in.enable || is.out.length < ethercat::min_mailbox_size ||
            is.in.length < ethercat::min_mailbox_size)
            throw failure{on.name_of(position) + ": its mailbox is not set up: take it to INIT, then to PRE-OP"};
        record.position = position;
        record.mailbox = mailbox;
        record.mailbox.receive_offset = is.out.start;
        record.mailbox.receive_size = is.out.length;
        record.mailbox.send_offset = is.in.start;
        record.mailbox.send_size = is.in.length;
        record.last_counter = static_cast<std::uint8_t>(jauscat::net::now().time_since_epoch().count() / 1000 % 7 + 1);
        agree_on_counter();
    }

    // A slave drops a request that has the same counter as the last one, which may have been another program's.
    void agree_on_counter() {
        for (int tries = 0;; ++tries) {
            std::array<std::byte, 64> into{};
            try {
                static_cast<void>(run(ethercat::sdo_transfer::upload(0x1000, 0, into), "object 0x1000:00"));
                return;
            } catch (const coe_failure& error) {
                if (error.error.code == master_errc::sdo_abort) return;
                if (error.error.code != master_errc::mailbox_timeout || tries == 1) throw;
            }
        }
    }

    void close() noexcept {
        if (!managers_before) return;
        try {
            on.write(position, registers::al_control, {.state = al_state::init, .acknowledge = true});
            for (int i = 0; i != 1000 && on.read(position, registers::al_status).state != al_state::init; ++i)
                ::usleep(1000);
            on.write(position, registers::mailbox_managers, {});
            on.write(position, registers::mailbox_managers.address, *managers_before);
        } catch (const std::exception& error) {
            note(std::string{"the slave was not taken back to INIT: "} + error.what());
        }
    }
};

namespace {

std::string place(std::uint16_t index, std::uint8_t subindex) {
    return "object " + hex(index, 4) + ":" + hex(subindex, 2).substr(2);
}

} // namespace

coe_mailbox::coe_mailbox(ring& on, std::uint16_t position) : is_{new state{.on = on, .position = position}} {
    try {
        is_->open();
    } catch (...) {
        is_->close();
        throw;
    }
}
coe_mailbox::~coe_mailbox() { is_->close(); }

bytes coe_mailbox::upload(std::uint16_t index, std::uint8_t subindex) {
    bytes into(65'536);
    into.resize(is_->run(ethercat::sdo_transfer::upload(index, subindex, into), place(index, subindex)));
    return into;
}

void coe_mailbox::download(std::uint16_t index, std::uint8_t subindex, const bytes& data) {
    static_cast<void>(is_->run(ethercat::sdo_transfer::download(index, subindex, data), place(index, subindex)));
}

std::vector<std::uint16_t> coe_mailbox::objects() {
    bytes into(131'072);
    const auto size =
        is_->run(ethercat::sdo_information::list(ethercat::object_list_type::all, into), "list of objects");
    const ethercat::object_indices found{std::span{into}.first(size)};
    return {found.begin(), found.end()};
}

object_text coe_mailbox::describe(std::uint16_t index) {
    bytes into(2048);
    const auto size =
        is_->run(ethercat::sdo_information::object(index, into), "description of object " + hex(index, 4));
    const auto made = ethercat::decode_object_description(std::span{into}.first(std::min(size, into.size())));
    if (!made) throw coe_failure{is_->on.name_of(is_->position) + ": " + reason_text(made.error()), made.error()};
    return {made->object, printable(made->name)};
}

entry_text coe_mailbox::describe(std::uint16_t index, std::uint8_t subindex) {
    bytes into(2048);
    constexpr std::uint8_t with_limits = 0x60;
    const auto size = is_->run(ethercat::sdo_information::entry({index, subindex, with_limits}, into),
                               "description of " + place(index, subindex));
    const auto made = ethercat::decode_entry_description(std::span{into}.first(std::min(size, into.size())));
    if (!made) throw coe_failure{is_->on.name_of(is_->position) + ": " + reason_text(made.error()), made.error()};
    return {made->entry,
            {made->minimum.begin(), made->minimum.end()},
            {made->maximum.begin(), made->maximum.end()},
            printable(made->name)};
}

std::optional<entry_text> coe_mailbox::try_describe(std::uint16_t index, std::uint8_t subindex) {
    if (is_->has_no_descriptions) return {};
    try {
        auto made = describe(index, subindex);
        if (subindex != 0 || !made.name.empty()) return made;
        try {
            made.name = describe(index).name;
        } catch (const coe_failure& error) {
            if (error.error.code != master_errc::sdo_abort) throw;
        }
        return made;
    } catch (const coe_failure& error) {
        // One that does not answer at all would cost the time of each further question.
        if (error.error.code != master_errc::sdo_abort) is_->has_no_descriptions = true;
        return {};
    }
}

std::optional<std::uint64_t> coe_mailbox::try_number(std::uint16_t index, std::uint8_t subindex) {
    try {
        std::array<std::byte, 8> into{};
        const auto size = is_->run(ethercat::sdo_transfer::upload(index, subindex, into), place(index, subindex));
        std::uint64_t made = 0;
        for (std::size_t i = std::min(size, into.size()); i-- != 0;)
            made = made << 8 | std::to_integer<std::uint64_t>(into[i]);
        return made;
    } catch (const coe_failure& error) {
        if (error.error.code != master_errc::sdo_abort) throw;
        return {};
    }
}

} // namespace ecat
