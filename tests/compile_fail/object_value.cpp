#include <jauscat/app/slave.hpp>

#ifdef GOOD
// expect: no error
void read(const jauscat::slave& drive) {
    drive.async_read<float>(0x6041, 0, [](boost::system::error_code, float) {});
    drive.async_write(0x6040, 0, std::uint16_t{6}, [](boost::system::error_code) {});
}
#endif

#ifdef TYPE
// expect: the value of an object is an integer, a bool, an enumeration, a float, a double,
void read(const jauscat::slave& drive) {
    drive.async_read<long double>(0x6041, 0, [](boost::system::error_code, long double) {});
}
#endif

#ifdef WRITTEN
// expect: the value of an object is an integer, a bool, an enumeration, a float, a double,
void write(const jauscat::slave& drive) {
    drive.async_write(0x6040, 0, std::vector<int>{6}, [](boost::system::error_code) {});
}
#endif
