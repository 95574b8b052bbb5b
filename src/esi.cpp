// ESI files.
#include <jauscat/esi/impl/check_esi.ipp>
#include <jauscat/esi/impl/device_sii.ipp>
#include <jauscat/esi/impl/emulated_device.ipp>
#include <jauscat/esi/impl/emulated_objects.ipp>
#include <jauscat/esi/impl/make_device.ipp>
#include <jauscat/esi/impl/read_esi.ipp>
#include <jauscat/esi/impl/text_values.ipp>
#include <jauscat/esi/impl/write_esi.ipp>
