"""How programs of 32-bit x86 run here: by the kernel, or in QEMU where a kernel of 64 bits refuses them."""
import os
import subprocess
import tempfile


def emulator():
    """None, or the program that runs them."""
    with tempfile.TemporaryDirectory() as folder:
        program = os.path.join(folder, "program")
        made = subprocess.run(["gcc", "-m32", "-static", "-x", "c", "-o", program, "-"], input="int main(void) { return 0; }",
                              capture_output=True, text=True, check=False)
        if made.returncode:     # whoever builds such programs says what is missing
            return None
        try:
            subprocess.run([program], check=True)
        except OSError:
            return "qemu-i386-static"
    return None
