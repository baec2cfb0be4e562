"""Tanks, epochs, runs, extractions with their inputs, results with stations, setups and checks."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None
branch_labels = None
depends_on = None

CREATED = (
    "run",
    "tank",
    "epoch",
    "extraction",
    "input",
    "result",
    "station",
    "setup",
    "code_check",
    "failure",
)


def upgrade() -> None:
    _run()
    _tank()
    _epoch()
    _extraction()
    _input()
    _result()
    _station()
    _setup()
    _code_check()
    _failure()


def downgrade() -> None:
    for name in reversed(CREATED):
        op.drop_table(name)


def _run() -> None:
    op.create_table(
        "run",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("site", sa.Text(), nullable=False),
        sa.Column("begun", sa.DateTime(), nullable=False),
        sa.Column("ended", sa.DateTime(), nullable=True),
        sa.Column("version", sa.Text(), nullable=False),
        sa.Column("options", sa.JSON(), nullable=False),
        sa.Column("ending", sa.Text(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
    )


def _tank() -> None:
    op.create_table(
        "tank",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("site", sa.Text(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("facts", sa.JSON(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
        sa.UniqueConstraint("site", "name"),
    )


def _epoch() -> None:
    op.create_table(
        "epoch",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("tank_id", sa.Integer(), nullable=False),
        sa.Column("label", sa.Text(), nullable=False),
        sa.Column("date", sa.Date(), nullable=False),
        sa.Column("fill_level", sa.Double(), nullable=True),
        sa.Column("hydrotest", sa.Text(), nullable=False),
        sa.Column("registration_error", sa.Double(), nullable=False),
        sa.Column("registration_tilt_arcsec", sa.Double(), nullable=False),
        sa.Column("marks", sa.JSON(), nullable=False),
        sa.ForeignKeyConstraint(
            ["tank_id"],
            ["tank.id"],
        ),
        sa.PrimaryKeyConstraint("id"),
        sa.UniqueConstraint("tank_id", "label"),
    )
    op.create_index("ix_epoch_tank_id", "epoch", ["tank_id"], unique=False)


def _extraction() -> None:
    op.create_table(
        "extraction",
        sa.Column("key", sa.Text(), nullable=False),
        sa.Column("run_id", sa.Integer(), nullable=False),
        sa.Column("job", sa.Text(), nullable=False),
        sa.Column("outcome", sa.Text(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("version", sa.Text(), nullable=False),
        sa.Column("seconds", sa.Double(), nullable=False),
        sa.Column("points", sa.BigInteger(), nullable=False),
        sa.ForeignKeyConstraint(
            ["run_id"],
            ["run.id"],
        ),
        sa.PrimaryKeyConstraint("key"),
    )
    op.create_index("ix_extraction_run_id", "extraction", ["run_id"], unique=False)


def _input() -> None:
    op.create_table(
        "input",
        sa.Column("extraction_key", sa.Text(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("url", sa.Text(), nullable=False),
        sa.Column("size", sa.BigInteger(), nullable=False),
        sa.Column("hash", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(
            ["extraction_key"],
            ["extraction.key"],
        ),
        sa.PrimaryKeyConstraint("extraction_key", "number"),
    )


def _result() -> None:
    op.create_table(
        "result",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("extraction_key", sa.Text(), nullable=False),
        sa.Column("epoch_id", sa.Integer(), nullable=False),
        sa.Column("folder", sa.Text(), nullable=False),
        sa.Column("status", sa.Text(), nullable=False),
        sa.Column("message", sa.Text(), nullable=False),
        sa.Column("centre_x", sa.Double(), nullable=True),
        sa.Column("centre_y", sa.Double(), nullable=True),
        sa.Column("radius", sa.Double(), nullable=True),
        sa.Column("verdict", sa.Text(), nullable=True),
        sa.Column("governing", sa.Text(), nullable=True),
        sa.Column("utilisation", sa.Double(), nullable=True),
        sa.Column("mean_z", sa.Double(), nullable=True),
        sa.Column("sigma_z", sa.Double(), nullable=True),
        sa.Column("measured", sa.Integer(), nullable=True),
        sa.Column("interpolated", sa.Integer(), nullable=True),
        sa.Column("missing", sa.Integer(), nullable=True),
        sa.Column("tilt_slope", sa.Double(), nullable=True),
        sa.Column("tilt_direction_deg", sa.Double(), nullable=True),
        sa.Column("sigma_tilt", sa.Double(), nullable=True),
        sa.Column("out_of_plane", sa.Double(), nullable=True),
        sa.ForeignKeyConstraint(
            ["epoch_id"],
            ["epoch.id"],
        ),
        sa.ForeignKeyConstraint(
            ["extraction_key"],
            ["extraction.key"],
        ),
        sa.PrimaryKeyConstraint("id"),
        sa.UniqueConstraint("extraction_key", "epoch_id"),
    )
    op.create_index("ix_result_epoch_id", "result", ["epoch_id"], unique=False)
    op.create_index(
        "ix_result_extraction_key", "result", ["extraction_key"], unique=False
    )


def _station() -> None:
    op.create_table(
        "station",
        sa.Column("result_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("azimuth_deg", sa.Double(), nullable=False),
        sa.Column("z", sa.Double(), nullable=True),
        sa.Column("sigma_z", sa.Double(), nullable=True),
        sa.Column("flag", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(
            ["result_id"],
            ["result.id"],
        ),
        sa.PrimaryKeyConstraint("result_id", "number"),
    )


def _setup() -> None:
    op.create_table(
        "setup",
        sa.Column("result_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("points", sa.BigInteger(), nullable=True),
        sa.Column("dz", sa.Double(), nullable=True),
        sa.Column("sigma_dz", sa.Double(), nullable=True),
        sa.Column("verdict", sa.Text(), nullable=True),
        sa.ForeignKeyConstraint(
            ["result_id"],
            ["result.id"],
        ),
        sa.PrimaryKeyConstraint("result_id", "number"),
    )


def _code_check() -> None:
    op.create_table(
        "code_check",
        sa.Column("result_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("code", sa.Text(), nullable=False),
        sa.Column("clause", sa.Text(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("value", sa.Double(), nullable=True),
        sa.Column("limit_value", sa.Double(), nullable=True),
        sa.Column("unit", sa.Text(), nullable=False),
        sa.Column("verdict", sa.Text(), nullable=False),
        sa.Column("role", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(
            ["result_id"],
            ["result.id"],
        ),
        sa.PrimaryKeyConstraint("result_id", "number"),
    )


def _failure() -> None:
    op.create_table(
        "failure",
        sa.Column("site", sa.Text(), nullable=False),
        sa.Column("job", sa.Text(), nullable=False),
        sa.Column("run_id", sa.Integer(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("attempts", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(
            ["run_id"],
            ["run.id"],
        ),
        sa.PrimaryKeyConstraint("site", "job"),
    )
    op.create_index("ix_failure_run_id", "failure", ["run_id"], unique=False)
