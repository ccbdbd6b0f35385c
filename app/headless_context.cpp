// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless_context.h"

#include <epoxy/egl.h>

#include <array>

namespace psm {
namespace {

constexpr const char* kRemedy = "; install Mesa's libegl1, libegl-mesa0 and libgl1-mesa-dri";

/// The display of no screen, or whatever display there is.
EGLDisplay open_display() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

EGLContext create_context(EGLDisplay display, EGLenum api, EGLint renderable, EGLint major, EGLint minor) {
  if (!eglBindAPI(api)) return EGL_NO_CONTEXT;
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, renderable, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  const std::array<EGLint, 7> core{
      EGL_CONTEXT_MAJOR_VERSION,           major,   EGL_CONTEXT_MINOR_VERSION, minor, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const std::array<EGLint, 5> es{EGL_CONTEXT_MAJOR_VERSION, major, EGL_CONTEXT_MINOR_VERSION, minor, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, api == EGL_OPENGL_API ? core.data() : es.data());
}

EGLContext create_context(EGLDisplay display, GlProfile profile) {
  EGLContext context = EGL_NO_CONTEXT;
  if (profile == GlProfile::core_or_es) context = create_context(display, EGL_OPENGL_API, EGL_OPENGL_BIT, 3, 3);
  if (context == EGL_NO_CONTEXT) context = create_context(display, EGL_OPENGL_ES_API, EGL_OPENGL_ES3_BIT, 3, 0);
  return context;
}

}  // namespace

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create(GlProfile profile) {
  std::unique_ptr<HeadlessContext> made(new HeadlessContext);
  made->display_ = open_display();
  if (made->display_ == EGL_NO_DISPLAY) return InputError{std::string("no EGL display: OpenGL cannot be used here") + kRemedy};
  made->context_ = create_context(made->display_, profile);
  if (made->context_ == EGL_NO_CONTEXT)
    return InputError{std::string("EGL gives neither OpenGL 3.3 nor OpenGL ES 3.0") + kRemedy};
  if (!eglMakeCurrent(made->display_, EGL_NO_SURFACE, EGL_NO_SURFACE, made->context_))
    return InputError{std::string("EGL cannot use a context without a surface") + kRemedy};
  return made;
}

HeadlessContext::~HeadlessContext() {
  if (display_ == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  // The display stays initialised: EGL gives the same one to everybody in this process, and terminating it would end their
  // contexts.
}

}  // namespace psm
