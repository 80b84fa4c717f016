"""From text to machine code by llvmlite, kept on disk by content for the next process."""

import ctypes
import hashlib
import os
import re
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

Binding: TypeAlias = Any  # llvmlite and what it makes: it has no types

_LOADED: list[Binding] = []
MARK = b"tam570 object 1\n"
_CALLED = re.compile(r"call(?: \w+)*? (<\d+ x double>|double|void|i64) @([\w.]+)\(([^)]*)\)")
_DEFINED = re.compile(r"^define [^@]*@([\w.]+)\(", re.MULTILINE)
_KIND = re.compile(r"(<\d+ x double>|\b(?:double|ptr|i64|i1)\b)[^,]*")


def assembled(lines: list[str]) -> str:
    """Return a module: these lines, and declarations of what they call and do not define."""
    text = "\n".join(lines) + "\n"
    defined = set(_DEFINED.findall(text))
    declared = {}
    for result, name, parameters in _CALLED.findall(text):
        if name not in defined:
            declared[name] = f"declare {result} @{name}({', '.join(_KIND.findall(parameters))})"
    return text + "\n".join(declared.values()) + "\n"


@cache
def _binding() -> tuple[Binding, str]:
    """llvmlite's binding, and what identifies it and this processor."""
    import llvmlite
    from llvmlite import binding

    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    name, features = binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    return binding, f"{llvmlite.__version__} {binding.llvm_version_info} {name} {features}"


def register_width() -> int:
    """Return how many doubles this processor adds at once."""
    return 8 if "+avx512f" in _binding()[1] else 4


def _machine(binding: Binding, effort: int) -> Binding:
    """Return a new one each time: the engine that is given it disposes of it."""
    name, features = binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    return binding.Target.from_default_triple().create_target_machine(name, features, opt=effort, jit=True)


def function(modules: Mapping[str, Callable[[], str]], entry: str, kinds: tuple[type, ...], effort: int = 2) -> Binding:
    """Return `entry` as a function from Python; other threads run while it does.

    modules : texts that call each other, each by what it follows from, together with the source of this package; a
              text is written if its code is not kept
    effort  : of the code generator, 0 to 3
    """
    binding, who = _binding()
    owner = binding.create_mcjit_compiler(binding.parse_assembly(""), _machine(binding, effort))
    codes = []
    for key, text in modules.items():
        name = hashlib.sha256(f"{_source()}\n{who}\n{effort}\n{key}".encode()).hexdigest()
        code = _kept(name)
        if code is None:
            code = _compiled(binding, text(), effort)
            _keep(name, code)
        owner.add_object_file(binding.ObjectFileRef.from_data(code))
        codes.append(code)
    owner.finalize_object()
    compiled_function = ctypes.CFUNCTYPE(None, *kinds)(owner.get_function_address(entry))
    _LOADED.append((owner.detach(), codes))  # never disposed of: its memory is read to the end, and somebody may run it
    return compiled_function


@cache
def _source() -> str:
    """Return what identifies the engine itself, of which the compiled code is a part."""
    files = sorted(Path(__file__).parents[1].rglob("*.py"))
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def _compiled(binding: Binding, text: str, effort: int) -> bytes:
    module, machine = binding.parse_assembly(text), _machine(binding, effort)
    module.verify()
    module.triple, module.data_layout = binding.get_default_triple(), str(machine.target_data)
    builder = binding.create_pass_builder(machine, binding.create_pipeline_tuning_options(speed_level=0))
    passes = binding.create_new_function_pass_manager()  # these alone: all of LLVM's take as long as the rest together
    passes.add_sroa_pass()
    passes.add_instruction_combine_pass()
    passes.add_simplify_cfg_pass()
    for each in module.functions:
        if not each.is_declaration:
            passes.run(each, builder)
    return bytes(machine.emit_object(module))


def folder() -> Path:
    """Return the user's folder for compiled code. OSError where there is none to be had."""
    base = os.environ.get("XDG_CACHE_HOME")
    cache_folder = (Path(base) if base else Path.home() / ".cache") / "tam570"
    cache_folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if hasattr(os, "getuid") and cache_folder.stat().st_uid != os.getuid():
        raise PermissionError(f"{cache_folder} belongs to somebody else")
    return cache_folder


def _kept(name: str) -> bytes | None:
    """Return the object code of that name, if what the file holds is what was written."""
    try:
        content = (folder() / f"{name}.o").read_bytes()
    except (OSError, RuntimeError):
        return None
    header, code = content[: len(MARK) + 32], content[len(MARK) + 32 :]
    return code if header == MARK + hashlib.sha256(name.encode() + code).digest() else None


def _keep(name: str, code: bytes) -> None:
    """Write at once or not at all: another process may want to read it; a folder that takes nothing is no error."""
    try:
        with tempfile.NamedTemporaryFile(dir=folder(), delete=False) as file:
            file.write(MARK + hashlib.sha256(name.encode() + code).digest() + code)
        os.replace(file.name, folder() / f"{name}.o")
    except (OSError, RuntimeError):
        return
