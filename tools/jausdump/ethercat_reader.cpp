#include "ethercat_reader.hpp"

namespace jausdump {

ethercat_reader::ethercat_reader(const object_table& how, ethercat_listener listener)
    : how_{how},
      listener_{std::move(listener)},
      transfers_{{.carried = [this](const object_transfer& object) { take(object); },
                  .refused =
                      [this](const object_transfer& object, const refusal& why) {
                          if (!is_message(object, how_)) return;
                          record message = head_of(object, how_);
                          message.origin = origin_of(object);
                          message.refusal = why;
                          listener_.refused(std::move(message));
                      },
                  .lost =
                      [this](const object_transfer& object) {
                          if (is_message(object, how_)) listener_.lost();
                      },
                  .skipped = listener_.skipped}},
      mailboxes_{{.message = [this](const mailbox_message& message) { transfers_.read(message); },
                  .skipped = listener_.skipped}} {}

void ethercat_reader::read(std::span<const std::byte> frame, const origin& from) {
    ++frames_;
    from_ = from;
    mailboxes_.read(frame);
}

void ethercat_reader::finish() {
    mailboxes_.finish();
    transfers_.finish();
}

origin ethercat_reader::origin_of(const object_transfer& object) const {
    origin made = from_;
    made.from = object.download ? "master" : to_text(object.slave);
    made.to = object.download ? to_text(object.slave) : "master";
    made.object = text::hex_number(object.index, 4) + ":" + std::to_string(object.subindex);
    return made;
}

void ethercat_reader::take(const object_transfer& object) {
    if (!is_message(object, how_)) return listener_.skipped("SDO of an object that is not a JAUS component's");
    const auto message = message_of(object, how_);
    if (message.error == jauscat::translate::errc::ok)
        listener_.message(message.bytes, origin_of(object));
    else
        listener_.unreadable(object.data, message.error, origin_of(object));
}

} // namespace jausdump
