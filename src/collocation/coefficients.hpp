/// @file
/// The numbers of Gauss' collocation with eight stages, rounded from eighty digits; tests/collocation.cpp tries them by
/// what they must do.
#pragma once

/// Motions of few degrees of freedom, integrated to rounding.
namespace collocation::coefficients
{

/// The stages, the zeros of Legendre's polynomial of the eighth degree on 0 to 1.
alignas(64) inline constexpr double c[8] = {
    0x1.454e34f533998p-6, 0x1.a06d536d82f88p-4, 0x1.e5dad4f9af698p-3, 0x1.a214dac30e32fp-2,
    0x1.2ef5929e78e69p-1, 0x1.86894ac19425ap-1, 0x1.cbf255924fa0fp-1, 0x1.f5d58e5856633p-1};
/// The weights: ∫F over the step is Σbⱼ Fⱼ, to the sixteenth order.
alignas(64) inline constexpr double b[8] = {
    0x1.9ea1d04ca0374p-5, 0x1.c76fb531d2b96p-4, 0x1.413c50a255615p-3, 0x1.736360b199343p-3,
    0x1.736360b199343p-3, 0x1.413c50a255615p-3, 0x1.c76fb531d2b96p-4, 0x1.9ea1d04ca0374p-5};
/// What they were rounded by.
alignas(64) inline constexpr double b_lost[8] = {
    0x1.1f1acb89ef946p-62,  -0x1.a88b639faee41p-58, 0x1.50ff06c1e9798p-57,  -0x1.0b64569cc3084p-58,
    -0x1.0b64569cc3084p-58, 0x1.50ff06c1e9798p-57,  -0x1.a88b639faee41p-58, 0x1.1f1acb89ef946p-62};
/// bⱼ(1 − cⱼ), the weights of the double integral.
alignas(64) inline constexpr double d[8] = {
    0x1.966647ea8d315p-5, 0x1.992234db003a2p-4, 0x1.ea0e29eccc9fcp-4, 0x1.b7837ee1a0933p-4,
    0x1.2f43428191d53p-4, 0x1.30d4eeafbc45dp-5, 0x1.726c02b693fa0p-7, 0x1.07710c4260beep-10};
/// What they were rounded by.
alignas(64) inline constexpr double d_lost[8] = {
    -0x1.9639224ea3c3dp-59, -0x1.9f56868e54261p-58, 0x1.2d0adf4161fb6p-58,  -0x1.b43a10c8d3801p-59,
    -0x1.8a3a71c2ca41bp-61, -0x1.1619a37b1e10bp-59, -0x1.269ba22b57c0cp-63, -0x1.78e1100792694p-65};
/// The barycentric weights of the stages, 1/Π(cⱼ − cₘ).
alignas(64) inline constexpr double w[8] = {
    -0x1.93eba693f7c23p+8,  0x1.443c4e72a3a77p+10, -0x1.0f08022e7b197p+11, 0x1.50b993ebd40f7p+11,
    -0x1.50b993ebd40f7p+11, 0x1.0f08022e7b197p+11, -0x1.443c4e72a3a77p+10, 0x1.93eba693f7c23p+8};
/// The coefficient of Legendre's polynomial of the seventh degree in F is Σ of these times Fⱼ.
alignas(64) inline constexpr double seventh[8] = {
    -0x1.e2117c36dc812p-4, 0x1.82f76a2825c73p-2, -0x1.4377f4482ea9fp-1, 0x1.91df45b961571p-1,
    -0x1.91df45b961571p-1, 0x1.4377f4482ea9fp-1, -0x1.82f76a2825c73p-2, 0x1.e2117c36dc812p-4};
/// That of the sixth degree.
alignas(64) inline constexpr double sixth[8] = {
    0x1.addbf5028cabdp-3,  -0x1.1e4352ab1b14cp-1, 0x1.3bb3a1f6988b0p-1,  -0x1.11ce991841427p-2,
    -0x1.11ce991841427p-2, 0x1.3bb3a1f6988b0p-1,  -0x1.1e4352ab1b14cp-1, 0x1.addbf5028cabdp-3};
/// Column j: ∫ from 0 to cᵢ of the polynomial that is 1 at cⱼ and 0 at the other stages, for each i.
alignas(64) inline constexpr double once[8][8] = {
    {0x1.9ea1d04ca0374p-6, 0x1.c0969f0491b57p-5, 0x1.8e0772c379454p-5, 0x1.a8e1e18b7a0c9p-5,
     0x1.9797dd2bb31abp-5, 0x1.a3b38b13c8993p-5, 0x1.9b01309f52724p-5, 0x1.a0e7ca72af3f3p-5},
    {-0x1.2a623059643d9p-7, 0x1.c76fb531d2b96p-5, 0x1.ef0a65b45e044p-4, 0x1.b2f7f1f3c39a5p-4,
     0x1.d488dbefee162p-4, 0x1.be51e06f1a1b4p-4, 0x1.cdd8a936078a1p-4, 0x1.c373b28c28764p-4},
    {0x1.9b9edc5e41f73p-8, -0x1.bef2e760de5e9p-7, 0x1.413c50a255615p-4, 0x1.5d88d3e0a4b9dp-3,
     0x1.3267d6576bd8ap-3, 0x1.4abed41279e60p-3, 0x1.3ace2e1f367c9p-3, 0x1.4529baa65b8dap-3},
    {-0x1.25cc85720e17fp-8, 0x1.0b0cb68260d4ep-7, -0x1.05bc709f53c37p-6, 0x1.736360b199343p-4,
     0x1.94330475c593fp-3, 0x1.623e2dbfa5083p-3, 0x1.7e11b966e0e8bp-3, 0x1.6d155c939d565p-3},
    {0x1.9381077ef778cp-9, -0x1.55cb16a8f690fp-8, 0x1.12532f1f42bf8p-7, -0x1.067d1e2162fe4p-6,
     0x1.736360b199343p-4, 0x1.941aeec583acap-3, 0x1.62b295497326ep-3, 0x1.7c91c4dd29a4fp-3},
    {-0x1.f6b5020316266p-10, 0x1.9b88a0c7b932ap-9, -0x1.30506e049095bp-8, 0x1.da8f495d31168p-8,
     -0x1.c4c833e4f5875p-7, 0x1.413c50a255615p-4, 0x1.5d2b7f1863474p-3, 0x1.345f59bf6351ap-3},
    {0x1.fe0152d5218bfp-11, -0x1.9a3d010d342f3p-10, 0x1.23ba985713c2ap-9, -0x1.a324d7c36b99cp-9,
     0x1.477c33e0f1f07p-8, -0x1.3cd584145a570p-7, 0x1.c76fb531d2b96p-5, 0x1.ecbbfb3cff411p-4},
    {-0x1.22fd130783f79p-12, 0x1.d04fd6a6e27fdp-12, -0x1.446eb1ca187b2p-11, 0x1.c27cc83b4724fp-11,
     -0x1.480227db3aaacp-10, 0x1.09a5d8926f208p-9, -0x1.0fa675bf8bf1ap-8, 0x1.9ea1d04ca0374p-6}};
/// The same integrated twice.
alignas(64) inline constexpr double twice[8][8] = {
    {0x1.3ed8b64bc803fp-12, 0x1.0878b0ed93f25p-8, 0x1.6b5a00f071747p-7, 0x1.40cc6bd3b8a6cp-6,
     0x1.db72a959bec6ap-6, 0x1.337c67f188a03p-5, 0x1.6cb30f3326dbap-5, 0x1.8ddbebff0a3bep-5},
    {-0x1.e53cff112a792p-13, 0x1.76171b9041f6ep-10, 0x1.e178c2139b4d1p-7, 0x1.199fec4bdd0afp-5,
     0x1.bc52b9b121a80p-5, 0x1.2dfd3020b61e6p-4, 0x1.6a17a2f0716d7p-4, 0x1.9096fe11c1221p-4},
    {0x1.17ee6a26116eep-12, -0x1.195b4516e4665p-11, 0x1.7297f8387fc72p-9, 0x1.ac84f43446805p-6,
     0x1.cb5a6d1c40d52p-5, 0x1.500dc7ab14896p-4, 0x1.aa01e37591441p-4, 0x1.dc72d7ad82ed5p-4},
    {-0x1.2c8416097718ap-12, 0x1.e7c941adccb6ap-12, -0x1.990c894da1b54p-11, 0x1.eec5a77a2a813p-9,
     0x1.09a7420751e1fp-5, 0x1.0988de91faf3cp-4, 0x1.6a536ba262a00p-4, 0x1.a9dc7a8b920acp-4},
    {0x1.1870a0d829536p-12, -0x1.ac1050226b717p-12, 0x1.1dc79157c698cp-11, -0x1.b64dae32e681bp-11,
     0x1.eec5a77a2a813p-9, 0x1.ef6be7f28594ap-6, 0x1.cb4e11a848346p-5, 0x1.1f574974a1ac6p-4},
    {-0x1.b3692b69e9a0ap-13, 0x1.451fd587c54b6p-12, -0x1.95eae9d9f385dp-12, 0x1.ee6012118d079p-12,
     -0x1.61cf85e6ffa0ap-11, 0x1.7297f8387fc72p-9, 0x1.53996a03b4e47p-6, 0x1.19819030deed6p-5},
    {0x1.fee40f89a3278p-14, -0x1.7a2327789adb8p-13, 0x1.ccf31e85638e6p-13, -0x1.06781105fec59p-12,
     0x1.2b168b579d69fp-12, -0x1.8ee5b046e4a40p-12, 0x1.76171b9041f6ep-10, 0x1.227f905143495p-7},
    {-0x1.3b4e25bfbdc5ap-15, 0x1.d11e42e94b996p-15, -0x1.19005a4bf040ap-14, 0x1.39180e320083fp-14,
     -0x1.4f81f1aee9cfep-14, 0x1.6951a4a1943a6p-14, -0x1.b9c390b648a28p-14, 0x1.3ed8b64bc803fp-12}};

}  // namespace collocation::coefficients
