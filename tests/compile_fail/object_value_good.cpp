// expect: no error
#include <jauscat/app/slave.hpp>

void read(const jauscat::slave& drive) {
    drive.async_read<float>(0x6041, 0, [](boost::system::error_code, float) {});
    drive.async_write(0x6040, 0, std::uint16_t{6}, [](boost::system::error_code) {});
}
