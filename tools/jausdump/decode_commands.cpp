#include "decode_message.hpp"

namespace jausdump {

body_decoder find_command_decoder(std::uint16_t command_code) {
    return find_decoder_between<0x0001, 0x1FFF>(command_code);
}

} // namespace jausdump
