"""The history: a database by URL, brought to the present tables, written a result a transaction."""

from __future__ import annotations

import contextlib
import datetime
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

from sqlalchemy import Connection, Engine, create_engine, event, select
from sqlalchemy.exc import (
    DBAPIError,
    IntegrityError,
    OperationalError,
    ProgrammingError,
    SQLAlchemyError,
)
from sqlalchemy.orm import Session

import tank_datum
from tank_datum.farm.campaign import Campaign
from tank_datum.farm.errors import AwayError, FarmError
from tank_datum.farm.models import Failure, Run
from tank_datum.farm.named_rows import tank_id

Made = TypeVar("Made")
BUSY = 2.0  # seconds that a write waits for another's lock before it is tried again


def database_url(campaign: Campaign) -> str:
    """SQLAlchemy's URL: as given, or of a SQLite file below the campaign's folder."""
    given = campaign.database
    if "://" not in given or given.startswith("sqlite:///"):
        return f"sqlite:///{campaign.folder / given.removeprefix('sqlite:///')}"
    for prefix in ("postgresql://", "postgres://"):
        given = (
            given.replace(prefix, "postgresql+psycopg://", 1)
            if given.startswith(prefix)
            else given
        )
    return given


class History:
    """An open history. Raises FarmError where the database cannot be reached or used."""

    def __init__(self, url: str) -> None:
        self.engine = _engine(url)

    def upgrade(self, revision: str = "head") -> None:
        """Brings the tables to a revision; data are kept."""
        self._migrate("upgrade", revision)

    def downgrade(self, revision: str) -> None:
        """Takes the tables back to an earlier revision, "base" for none."""
        self._migrate("downgrade", revision)

    def _migrate(self, direction: str, revision: str) -> None:
        from alembic import command
        from alembic.config import Config
        from alembic.runtime.migration import MigrationContext
        from alembic.script import ScriptDirectory
        from alembic.util import CommandError

        config = Config()
        config.set_main_option("script_location", "tank_datum.farm:migrations")
        try:
            with self.engine.connect() as connection:
                present = MigrationContext.configure(connection).get_current_revision()
                connection.rollback()
                head = ScriptDirectory.from_config(config).get_current_head()
                if revision == "head" and present == head:
                    return
                with _migrating(connection):
                    config.attributes["connection"] = connection
                    getattr(command, direction)(config, revision)
        except (OperationalError, ProgrammingError, IntegrityError) as error:
            raise AwayError(
                f"database: {cause(error)}"
            ) from None  # or made by another client now
        except SQLAlchemyError as error:
            raise FarmError(f"database: {cause(error)}") from None
        except CommandError as error:
            reason = f"{cause(error)}; it is of another version of tank_datum"
            raise FarmError(f"database: {reason}") from None

    @contextlib.contextmanager
    def session(self) -> Iterator[Session]:
        """One transaction: all or nothing. Raises SQLAlchemyError."""
        with Session(self.engine, expire_on_commit=False) as session, session.begin():
            yield session

    def begin_run(self, campaign: Campaign) -> int:
        """Notes a run with its tanks and epochs; its number."""
        with self.session() as session:
            run = Run(
                site=campaign.site,
                begun=_now(),
                version=tank_datum.__version__,
                options={"campaign": campaign.path.name, "options": campaign.options},
            )
            session.add(run)
            for tank in campaign.tanks:
                tank_id(session, campaign.site, tank)
            session.flush()
            return run.id

    def end_run(self, run_id: int, ending: str) -> None:
        with self.session() as session:
            run = session.get_one(Run, run_id)
            run.ended, run.ending = _now(), ending

    def failures(self, site: str) -> list[Failure]:
        with self.session() as session:
            found = select(Failure).where(Failure.site == site).order_by(Failure.job)
            return list(session.scalars(found))

    def close(self) -> None:
        self.engine.dispose()


def _engine(url: str) -> Engine:
    try:
        if not url.startswith("sqlite"):
            return create_engine(
                url, pool_pre_ping=True, connect_args={"connect_timeout": 5}
            )
        path = url.removeprefix("sqlite:///")
        if path and path != url:
            Path(path).parent.mkdir(parents=True, exist_ok=True)
        engine = create_engine(url, connect_args={"timeout": BUSY})
    except (SQLAlchemyError, ImportError, OSError, TypeError, ValueError) as error:
        raise FarmError(f"database: {cause(error)}") from None

    @event.listens_for(engine, "connect")
    def prepare(connection: Any, _: Any) -> None:
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA foreign_keys=ON")

    return engine


@contextlib.contextmanager
def _migrating(connection: Connection) -> Iterator[None]:
    """One transaction for all: SQLite's driver would end it at every change of a table, and its
    tables are made anew, which foreign keys would refuse."""
    if connection.dialect.name != "sqlite":
        with connection.begin():
            yield
        return
    driver = connection.connection.dbapi_connection
    assert driver is not None
    before, driver.isolation_level = driver.isolation_level, None
    try:
        connection.exec_driver_sql("PRAGMA foreign_keys=OFF")
        connection.exec_driver_sql("BEGIN IMMEDIATE")
        yield
        connection.commit()
    except BaseException:
        connection.rollback()
        raise
    finally:
        connection.exec_driver_sql("PRAGMA foreign_keys=ON")
        driver.isolation_level = before


def cause(error: BaseException) -> str:
    """One line without the statement."""
    inner = error.orig if isinstance(error, DBAPIError) and error.orig else error
    return " ".join(str(inner).split())[:500]


def _now() -> datetime.datetime:
    return datetime.datetime.now(datetime.UTC).replace(tzinfo=None, microsecond=0)


def open_history(
    campaign: Campaign,
    within: float = 0.0,
    say: Callable[[str], None] = lambda text: None,
) -> History:
    """The campaign's history with the present tables. Raises FarmError, after so many seconds where
    the database may come back."""
    end, told = time.monotonic() + within, False
    while True:
        history = History(database_url(campaign))
        try:
            history.upgrade()
            return history
        except AwayError as error:
            history.close()
            if time.monotonic() >= end:
                raise
            if not told:
                say(f"the database is away ({error}); waiting for it")
            told = True
            time.sleep(0.5)
        except FarmError:
            history.close()
            raise


def patient(function: Callable[[], Made], within: float) -> Made:
    """What it gives, asked again for so many seconds while the database is locked or away."""
    end = time.monotonic() + within
    while True:
        try:
            return function()
        except OperationalError:
            if time.monotonic() >= end:
                raise
            time.sleep(0.5)
