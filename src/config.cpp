// The reader of JausConfig.xml.
#include <jauscat/net/config/impl/read_jaus_config.ipp>
