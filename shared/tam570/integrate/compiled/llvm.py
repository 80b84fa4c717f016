"""Compiles LLVM text with llvmlite and caches the machine code on disk."""

import ctypes
import hashlib
import os
import re
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

Binding: TypeAlias = Any  # llvmlite and its objects, which have no type hints

_LOADED: list[Binding] = []
MARK = b"tam570 object 1\n"
_CALLED = re.compile(r"call(?: \w+)*? (<\d+ x double>|double|void|i64) @([\w.]+)\(([^)]*)\)")
_DEFINED = re.compile(r"^define [^@]*@([\w.]+)\(", re.MULTILINE)
_KIND = re.compile(r"(<\d+ x double>|\b(?:double|ptr|i64|i1)\b)[^,]*")


def assembled(lines: list[str]) -> str:
    """Return the text of a module: the lines, and declarations of the external functions that they call."""
    text = "\n".join(lines) + "\n"
    defined = set(_DEFINED.findall(text))
    declared = {}
    for result, name, parameters in _CALLED.findall(text):
        if name not in defined:
            declared[name] = f"declare {result} @{name}({', '.join(_KIND.findall(parameters))})"
    return text + "\n".join(declared.values()) + "\n"


@cache
def _binding() -> tuple[Binding, str]:
    """Return llvmlite's binding, and a string that identifies its version and this processor."""
    import llvmlite
    from llvmlite import binding

    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    name, features = binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    return binding, f"{llvmlite.__version__} {binding.llvm_version_info} {name} {features}"


def register_width() -> int:
    """Return how many doubles a vector register of this processor contains."""
    return 8 if "+avx512f" in _binding()[1] else 4


def _machine(binding: Binding, effort: int) -> Binding:
    """Return a new target machine; the execution engine that receives it disposes of it."""
    name, features = binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    return binding.Target.from_default_triple().create_target_machine(name, features, opt=effort, jit=True)


def function(modules: Mapping[str, Callable[[], str]], entry: str, kinds: tuple[type, ...], effort: int = 2) -> Binding:
    """Return `entry` of the linked modules as a function that Python can call; it releases the GIL.

    modules : cache key -> function that writes the text, called only if the cache has no code for the key and the
              source of this package
    effort  : optimization level of the code generator, 0 to 3
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
    _LOADED.append((owner.detach(), codes))  # never freed: another thread may still run the code
    return compiled_function


@cache
def _source() -> str:
    """Return a hash of the integrate package's source, from which the compiled code is generated."""
    files = sorted(Path(__file__).parents[1].rglob("*.py"))
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def _compiled(binding: Binding, text: str, effort: int) -> bytes:
    module, machine = binding.parse_assembly(text), _machine(binding, effort)
    module.verify()
    module.triple, module.data_layout = binding.get_default_triple(), str(machine.target_data)
    builder = binding.create_pass_builder(machine, binding.create_pipeline_tuning_options(speed_level=0))
    passes = binding.create_new_function_pass_manager()  # LLVM's default pipeline would double the compile time
    passes.add_sroa_pass()
    passes.add_instruction_combine_pass()
    passes.add_simplify_cfg_pass()
    for each in module.functions:
        if not each.is_declaration:
            passes.run(each, builder)
    return bytes(machine.emit_object(module))


def folder() -> Path:
    """Return the user's cache folder for compiled code; raise OSError if it cannot be created."""
    base = os.environ.get("XDG_CACHE_HOME")
    cache_folder = (Path(base) if base else Path.home() / ".cache") / "tam570"
    cache_folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if hasattr(os, "getuid") and cache_folder.stat().st_uid != os.getuid():
        raise PermissionError(f"{cache_folder} belongs to somebody else")
    return cache_folder


def _kept(name: str) -> bytes | None:
    """Return the cached object code of that name; None if the file is missing or damaged."""
    try:
        content = (folder() / f"{name}.o").read_bytes()
    except (OSError, RuntimeError):
        return None
    header, code = content[: len(MARK) + 32], content[len(MARK) + 32 :]
    return code if header == MARK + hashlib.sha256(name.encode() + code).digest() else None


def _keep(name: str, code: bytes) -> None:
    """Cache object code by an atomic rename, for concurrent processes; ignore a folder that is not writable."""
    try:
        with tempfile.NamedTemporaryFile(dir=folder(), delete=False) as file:
            file.write(MARK + hashlib.sha256(name.encode() + code).digest() + code)
        os.replace(file.name, folder() / f"{name}.o")
    except (OSError, RuntimeError):
        return
