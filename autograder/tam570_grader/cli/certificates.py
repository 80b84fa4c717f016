"""The command `tam570-grader certificates`, which makes a cluster's certificate; only holders of the key can join."""

import argparse
import datetime
import importlib.util
import os
from pathlib import Path

from tam570_grader.errors import UsageError, say, writing
from tam570_grader.grading.cluster import CERTIFICATES, certificate_and_key

YEARS = 2


NEXT = """\
{folder}: a certificate and its key, good until {until}. Whoever has the key can run code on the cluster.
Copy the folder to each machine by a safe way (scp), and start there:
    dask scheduler --no-dashboard --port 8786 {tls}
    dask worker tls://HOST:8786 --nworkers auto --nthreads 1 {tls}
Then grade here:
    tam570-grader grade submitted/ --out results/ --cluster tls://HOST:8786 --certificates {folder}"""


def add_certificates(parser: argparse.ArgumentParser) -> None:
    """Add the options of `certificates`."""
    parser.set_defaults(command=_certificates)
    parser.description = (
        "Make a certificate and a key that scheduler, workers and `grade --cluster` know each other by."
    )
    parser.add_argument("folder", type=Path, metavar="DIR", help="a new folder, for you alone")


def _certificates(arguments: argparse.Namespace) -> int:
    if importlib.util.find_spec("cryptography") is None:
        raise UsageError("certificates need cryptography: pip install 'tam570[cluster]'")
    folder: Path = arguments.folder
    until = datetime.datetime.now(datetime.UTC) + datetime.timedelta(days=365 * YEARS)
    with writing(folder):
        folder.mkdir(mode=0o700, parents=True)
        for name, content in zip(CERTIFICATES, _certificate_and_key(until), strict=True):
            with open(os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as file:
                file.write(content)
    certificate, key = certificate_and_key(folder)
    tls = f"--tls-ca-file {certificate} --tls-cert {certificate} --tls-key {key}"
    say(NEXT.format(folder=folder, until=f"{until:%d %b %Y}", tls=tls))
    return 0


def _certificate_and_key(until: datetime.datetime) -> tuple[bytes, bytes]:
    """Return a self-signed certificate and its private key, in PEM format."""
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import ec

    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "tam570 cluster")])
    key_identifier = x509.SubjectKeyIdentifier.from_public_key(key.public_key())
    builder = (
        x509.CertificateBuilder(name, name, key.public_key(), x509.random_serial_number())
        .not_valid_before(datetime.datetime.now(datetime.UTC) - datetime.timedelta(days=1))  # other clocks may be slow
        .not_valid_after(until)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(key_identifier, critical=False)
        .add_extension(x509.AuthorityKeyIdentifier.from_issuer_subject_key_identifier(key_identifier), critical=False)
    )
    certificate = builder.sign(key, hashes.SHA256())
    secret = key.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    return certificate.public_bytes(serialization.Encoding.PEM), secret
