"""The tables of the history. Metres, degrees; unknown is NULL."""

from __future__ import annotations

import datetime
from typing import Any, ClassVar

from sqlalchemy import JSON, BigInteger, ForeignKey, Text, UniqueConstraint
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column, relationship

CASCADE = "all, delete-orphan"


class Base(DeclarativeBase):
    type_annotation_map: ClassVar = {dict[str, Any]: JSON, str: Text}


class Tank(Base):
    """A tank of a site, as the campaign last said it is."""

    __tablename__ = "tank"
    __table_args__ = (UniqueConstraint("site", "name"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    site: Mapped[str]
    name: Mapped[str]
    facts: Mapped[dict[str, Any]]


class Epoch(Base):
    """A survey of a tank. kind: "scan" or "levelling"."""

    __tablename__ = "epoch"
    __table_args__ = (UniqueConstraint("tank_id", "label"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    tank_id: Mapped[int] = mapped_column(ForeignKey("tank.id"), index=True)
    label: Mapped[str]
    date: Mapped[datetime.date]
    fill_level: Mapped[float | None]
    hydrotest: Mapped[str]
    registration_error: Mapped[float]
    registration_tilt_arcsec: Mapped[float]
    marks: Mapped[dict[str, Any]]
    kind: Mapped[str] = mapped_column(server_default="scan")
    tank: Mapped[Tank] = relationship()


class Run(Base):
    """A run of a campaign: with what version and options, and how it ended."""

    __tablename__ = "run"
    id: Mapped[int] = mapped_column(primary_key=True)
    site: Mapped[str]
    begun: Mapped[datetime.datetime]
    ended: Mapped[datetime.datetime | None]
    version: Mapped[str]
    options: Mapped[dict[str, Any]]
    ending: Mapped[str] = mapped_column(default="")


class Extraction(Base):
    """One task that came to its end: a datum, or the reason why the scan gives none."""

    __tablename__ = "extraction"
    key: Mapped[str] = mapped_column(primary_key=True)
    run_id: Mapped[int] = mapped_column(ForeignKey("run.id"), index=True)
    job: Mapped[str]
    outcome: Mapped[str]
    reason: Mapped[str]
    version: Mapped[str]
    seconds: Mapped[float]
    points: Mapped[int] = mapped_column(BigInteger)
    worker: Mapped[str] = mapped_column(server_default="")
    inputs: Mapped[list[Input]] = relationship(cascade=CASCADE)
    results: Mapped[list[Result]] = relationship(cascade=CASCADE)


class Input(Base):
    """A file that an extraction read."""

    __tablename__ = "input"
    extraction_key: Mapped[str] = mapped_column(
        ForeignKey("extraction.key"), primary_key=True
    )
    number: Mapped[int] = mapped_column(primary_key=True)
    url: Mapped[str]
    size: Mapped[int] = mapped_column(BigInteger)
    hash: Mapped[str]


class Result(Base):
    """The datum of one tank at one epoch. folder: below the store's folder of the key."""

    __tablename__ = "result"
    __table_args__ = (UniqueConstraint("extraction_key", "epoch_id"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    extraction_key: Mapped[str] = mapped_column(
        ForeignKey("extraction.key"), index=True
    )
    epoch_id: Mapped[int] = mapped_column(ForeignKey("epoch.id"), index=True)
    folder: Mapped[str]
    status: Mapped[str]
    message: Mapped[str]
    centre_x: Mapped[float | None]
    centre_y: Mapped[float | None]
    radius: Mapped[float | None]
    verdict: Mapped[str | None]
    governing: Mapped[str | None]
    utilisation: Mapped[float | None]
    mean_z: Mapped[float | None]
    sigma_z: Mapped[float | None]
    measured: Mapped[int | None]
    interpolated: Mapped[int | None]
    missing: Mapped[int | None]
    tilt_slope: Mapped[float | None]
    tilt_direction_deg: Mapped[float | None]
    sigma_tilt: Mapped[float | None]
    out_of_plane: Mapped[float | None]
    extraction: Mapped[Extraction] = relationship(back_populates="results")
    epoch: Mapped[Epoch] = relationship()
    stations: Mapped[list[Station]] = relationship(cascade=CASCADE)
    setups: Mapped[list[Setup]] = relationship(cascade=CASCADE)
    checks: Mapped[list[Check]] = relationship(cascade=CASCADE)


class Station(Base):
    """A row of stations.csv."""

    __tablename__ = "station"
    result_id: Mapped[int] = mapped_column(ForeignKey("result.id"), primary_key=True)
    number: Mapped[int] = mapped_column(primary_key=True)
    azimuth_deg: Mapped[float]
    z: Mapped[float | None]
    sigma_z: Mapped[float | None]
    flag: Mapped[str]


class Setup(Base):
    """A setup of the scanner, and how it agrees with the others."""

    __tablename__ = "setup"
    result_id: Mapped[int] = mapped_column(ForeignKey("result.id"), primary_key=True)
    number: Mapped[int] = mapped_column(primary_key=True)
    name: Mapped[str]
    points: Mapped[int | None] = mapped_column(BigInteger)
    dz: Mapped[float | None]
    sigma_dz: Mapped[float | None]
    verdict: Mapped[str | None]


class Check(Base):
    """A figure beside the limit of a code, in `unit`."""

    __tablename__ = "code_check"
    result_id: Mapped[int] = mapped_column(ForeignKey("result.id"), primary_key=True)
    number: Mapped[int] = mapped_column(primary_key=True)
    code: Mapped[str]
    clause: Mapped[str]
    name: Mapped[str]
    value: Mapped[float | None]
    limit_value: Mapped[float | None]
    unit: Mapped[str]
    verdict: Mapped[str]
    role: Mapped[str]


class Movement(Base):
    """What moved between two results. asked: hash of what the comparison was asked."""

    __tablename__ = "movement"
    baseline_id: Mapped[int] = mapped_column(ForeignKey("result.id"), primary_key=True)
    result_id: Mapped[int] = mapped_column(ForeignKey("result.id"), primary_key=True)
    asked: Mapped[str] = mapped_column(primary_key=True)
    figures: Mapped[dict[str, Any]]


class Failure(Base):
    """A survey whose last try did not come to an end; gone when it does."""

    __tablename__ = "failure"
    site: Mapped[str] = mapped_column(primary_key=True)
    job: Mapped[str] = mapped_column(primary_key=True)
    run_id: Mapped[int] = mapped_column(ForeignKey("run.id"), index=True)
    kind: Mapped[str]
    reason: Mapped[str]
    attempts: Mapped[int]
