"""What a desktop tells programs on an X display, told by a test: resources, panels, a window manager that answers.

Through the library of X that the viewer needs anyway, so that no program must be installed for it.
"""
import ctypes
import socket
import struct
import threading

REPLACE, CLIENT_MESSAGE, SUBSTRUCTURE_NOTIFY = 0, 33, 1 << 19
X = ctypes.CDLL("libX11.so.6")
X.XOpenDisplay.restype = ctypes.c_void_p
X.XDefaultRootWindow.restype = ctypes.c_ulong
X.XInternAtom.restype = ctypes.c_ulong
X.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
X.XChangeProperty.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_int, ctypes.c_int,
                              ctypes.c_char_p, ctypes.c_int]
for function in (X.XDefaultRootWindow, X.XCloseDisplay, X.XFlush, X.XPending, X.XConnectionNumber):
    function.argtypes = [ctypes.c_void_p]
X.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
X.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
X.XSelectInput.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_long]
X.XNextEvent.argtypes = [ctypes.c_void_p, ctypes.c_void_p]


class Desktop:
    """A connection to the display of a screen; what is set lasts as long as the display."""

    def __init__(self, screen):
        self.display = X.XOpenDisplay(screen.env["DISPLAY"].encode())
        if not self.display:
            raise AssertionError("the display cannot be opened")
        self.root = X.XDefaultRootWindow(self.display)
        self.ended = threading.Event()
        self.thread = None

    def close(self):
        self.ended.set()
        if self.thread:
            self.thread.join()
        X.XCloseDisplay(self.display)

    def atom(self, name):
        return X.XInternAtom(self.display, name.encode(), False)

    def set(self, name, kind, values, window=None):
        """`values`: text, or numbers of 32 bits, which X wants as C's longs."""
        text = isinstance(values, str)
        data = values.encode() if text else struct.pack(f"{len(values)}l", *values)
        X.XChangeProperty(self.display, window or self.root, self.atom(name), self.atom(kind), 8 if text else 32, REPLACE, data,
                          len(values))
        X.XSync(self.display, False)

    def ask_to_close(self, window):
        """What a window manager does at a click on the close button."""
        values = [CLIENT_MESSAGE, 0, 1, self.display, window, self.atom("WM_PROTOCOLS"), 32, self.atom("WM_DELETE_WINDOW")]
        X.XSendEvent(self.display, window, False, 0, (ctypes.c_long * 24)(*values))
        X.XSync(self.display, False)

    def resources(self, text):
        self.set("RESOURCE_MANAGER", "STRING", text)

    def work_area(self, *areas):
        self.set("_NET_WORKAREA", "CARDINAL", [number for area in areas for number in area])

    def monitors(self, screen, *areas):
        """Monitors that show parts of the screen, as XRandR 1.5 lets users define them, in plain words of X's protocol: the
        library for it need not be there. The one that shows all of it stays."""
        with socket.socket(socket.AF_UNIX) as server:
            server.connect("/tmp/.X11-unix/X" + screen.env["DISPLAY"].removeprefix(":"))

            def receive(count):
                data = b""
                while len(data) < count:
                    data += server.recv(count - len(data))
                return data

            server.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, 0, 0))
            receive(4 * struct.unpack("<xxxxxxH", receive(8))[0])
            server.sendall(struct.pack("<BxHHxx", 98, 4, 5) + b"RANDR" + bytes(3))  # QueryExtension
            _, opcode = struct.unpack("<BB", receive(32)[8:10])
            for i, (x, y, width, height) in enumerate(areas):  # RRSetMonitor
                server.sendall(struct.pack("<BBHIIBBHhhHHII", opcode, 43, 8, self.root, self.atom(f"monitor{i}"), False, False, 0,
                                           x, y, width, height, 100, 100))
            server.sendall(struct.pack("<BxH", 43, 1))  # GetInputFocus: once it is answered, all is done
            if receive(32)[0] != 1:
                raise AssertionError("monitors cannot be defined")

    def manage(self, frame=None):
        """There is a window manager. It says which frame (left, right, top, bottom) a window will get, if one is given."""
        self.set("_NET_SUPPORTING_WM_CHECK", "WINDOW", [self.root])
        if not frame:
            return
        ask = self.atom("_NET_REQUEST_FRAME_EXTENTS")
        self.set("_NET_SUPPORTED", "ATOM", [ask])
        X.XSelectInput(self.display, self.root, SUBSTRUCTURE_NOTIFY)
        X.XSync(self.display, False)

        def answer():
            event = (ctypes.c_long * 24)()
            while not self.ended.wait(0.01):
                while X.XPending(self.display):
                    X.XNextEvent(self.display, event)
                    # Of a ClientMessage: type, serial, whether it was sent, display, window, what is asked.
                    if event[0] & 0xffffffff == CLIENT_MESSAGE and event[5] == ask:
                        self.set("_NET_FRAME_EXTENTS", "CARDINAL", frame, event[4])

        self.thread = threading.Thread(target=answer)
        self.thread.start()
