//! The triangles as Mesa's llvmpipe draws them, through OSMesa: vertex arrays, glDrawArrays, glFinish, with the depth
//! test and without. The library is opened at run time; without it the comparison is left out.
//!
//! All `unsafe` of this package is here: calls through C function pointers. Each symbol is given the signature that the
//! headers GL/gl.h and GL/osmesa.h declare; the library outlives the pointers, since both are in [`Mesa`]; arrays handed
//! to GL outlive the calls that read them, because glFinish has returned before they can change.

use super::shape::{Triangle, SIDE};
use libloading::{Library, Symbol};
use std::ffi::{c_void, CStr};

/// Names under which the library is installed.
const NAMES: [&str; 3] = ["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"];

// From GL/gl.h and GL/osmesa.h.
const RGBA: u32 = 0x1908;
const UNSIGNED_BYTE: u32 = 0x1401;
const FLOAT: u32 = 0x1406;
const TRIANGLES: u32 = 4;
const DEPTH_TEST: u32 = 0x0B71;
const GREATER: u32 = 0x0204;
const COLOR_BUFFER: u32 = 0x4000;
const DEPTH_BUFFER: u32 = 0x0100;
const PROJECTION: u32 = 0x1701;
const VERTEX_ARRAY: u32 = 0x8074;
const COLOR_ARRAY: u32 = 0x8076;
const RENDERER: u32 = 0x1F01;
const VERSION: u32 = 0x1F02;
const SMOOTH: u32 = 0x1D01;
const FLAT: u32 = 0x1D00;

type Enum = extern "C" fn(u32);
type Pointer = extern "C" fn(i32, u32, i32, *const c_void);

/// A context of its own, the frame it draws to, and the arrays it draws from.
pub struct Mesa {
    /// Renderer and version, as they name themselves.
    pub name: String,
    frame: Vec<u32>,
    positions: Vec<[f32; 3]>,
    colours: Vec<[f32; 3]>,
    clear: Enum,
    enable: Enum,
    disable: Enum,
    shade_model: Enum,
    draw_arrays: extern "C" fn(u32, i32, i32),
    vertex_pointer: Pointer,
    color_pointer: Pointer,
    finish: extern "C" fn(),
    /// Keeps the functions above in memory.
    _library: Library,
}

impl Mesa {
    /// Opens the library and makes a context that draws on the calling thread alone.
    ///
    /// # Errors
    /// Why there is none, in one line.
    pub fn open() -> Result<Self, String> {
        // llvmpipe reads it when it starts: no threads beside the caller's, unless the user wants them.
        if std::env::var_os("LP_NUM_THREADS").is_none() {
            std::env::set_var("LP_NUM_THREADS", "0");
        }
        // SAFETY: Mesa's initialisers have no preconditions.
        let open = |name: &&str| unsafe { Library::new(*name) }.ok();
        let library = NAMES
            .iter()
            .find_map(open)
            .ok_or("OSMesa is not installed (apt-get install libosmesa6): Mesa is left out")?;
        Self::with(library).map_err(|e| format!("OSMesa cannot be used ({e}): Mesa is left out"))
    }

    fn with(library: Library) -> Result<Self, String> {
        /// A function of the library.
        fn get<T: Copy>(library: &Library, name: &str) -> Result<T, String> {
            // SAFETY: callers name the type that the headers declare for the symbol.
            let symbol: Symbol<'_, T> =
                unsafe { library.get(name.as_bytes()) }.map_err(|e| e.to_string())?;
            Ok(*symbol)
        }
        let l = &library;
        let create: extern "C" fn(u32, i32, i32, i32, *const c_void) -> *mut c_void =
            get(l, "OSMesaCreateContextExt")?;
        let current: extern "C" fn(*mut c_void, *mut c_void, u32, i32, i32) -> u8 =
            get(l, "OSMesaMakeCurrent")?;
        let string: extern "C" fn(u32) -> *const std::ffi::c_char = get(l, "glGetString")?;
        let (matrix_mode, depth_func): (Enum, Enum) =
            (get(l, "glMatrixMode")?, get(l, "glDepthFunc")?);
        let ortho: extern "C" fn(f64, f64, f64, f64, f64, f64) = get(l, "glOrtho")?;
        let clear_depth: extern "C" fn(f64) = get(l, "glClearDepth")?;
        let client_state: Enum = get(l, "glEnableClientState")?;
        let mut frame = vec![0u32; (SIDE * SIDE) as usize];
        let context = create(RGBA, 24, 0, 0, std::ptr::null());
        if context.is_null() {
            return Err("no context".to_owned());
        }
        let side = SIDE as i32;
        if current(
            context,
            frame.as_mut_ptr().cast(),
            UNSIGNED_BYTE,
            side,
            side,
        ) == 0
        {
            return Err("the context cannot be made current".to_owned());
        }
        let said = |what| {
            let text = string(what);
            if text.is_null() {
                return "?".to_owned();
            }
            // SAFETY: GL returns a string of its own that ends in zero and is never freed.
            unsafe { CStr::from_ptr(text) }
                .to_string_lossy()
                .into_owned()
        };
        let name = format!("{}, {}", said(RENDERER), said(VERSION));
        matrix_mode(PROJECTION);
        // Rows from the top; greater depths are nearer.
        ortho(0.0, SIDE.into(), SIDE.into(), 0.0, 0.0, -1.0);
        depth_func(GREATER);
        clear_depth(0.0);
        client_state(VERTEX_ARRAY);
        client_state(COLOR_ARRAY);
        Ok(Self {
            name,
            frame,
            positions: Vec::new(),
            colours: Vec::new(),
            clear: get(l, "glClear")?,
            enable: get(l, "glEnable")?,
            disable: get(l, "glDisable")?,
            shade_model: get(l, "glShadeModel")?,
            draw_arrays: get(l, "glDrawArrays")?,
            vertex_pointer: get(l, "glVertexPointer")?,
            color_pointer: get(l, "glColorPointer")?,
            finish: get(l, "glFinish")?,
            _library: library,
        })
    }

    /// Takes triangles over.
    pub fn take(&mut self, triangles: &[Triangle]) {
        let corners = || triangles.iter().flatten();
        self.positions = corners().map(|c| [c.x, c.y, c.depth]).collect();
        self.colours = corners().map(|c| c.colour).collect();
    }

    /// Clears and draws, with or without the depth test, in colours of corners or of triangles.
    pub fn draw(&mut self, depth_test: bool, smooth: bool) {
        (self.shade_model)(if smooth { SMOOTH } else { FLAT });
        if depth_test {
            (self.enable)(DEPTH_TEST);
            (self.clear)(COLOR_BUFFER | DEPTH_BUFFER);
        } else {
            (self.disable)(DEPTH_TEST);
            (self.clear)(COLOR_BUFFER);
        }
        (self.vertex_pointer)(3, FLOAT, 0, self.positions.as_ptr().cast());
        (self.color_pointer)(3, FLOAT, 0, self.colours.as_ptr().cast());
        (self.draw_arrays)(TRIANGLES, 0, self.positions.len() as i32);
        (self.finish)();
    }

    /// Pixels that are not black, where every colour drawn is not.
    pub fn covered(&self) -> u64 {
        let seen = |p: &&u32| **p & 0x00FF_FFFF != 0;
        self.frame.iter().filter(seen).count() as u64
    }
}
