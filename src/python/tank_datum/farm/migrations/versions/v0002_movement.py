"""Movements between results, and on which worker an extraction ran."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("extraction") as table:
        table.add_column(
            sa.Column("worker", sa.Text(), server_default="", nullable=False)
        )
    op.create_table(
        "movement",
        sa.Column("baseline_id", sa.Integer(), nullable=False),
        sa.Column("result_id", sa.Integer(), nullable=False),
        sa.Column("asked", sa.Text(), nullable=False),
        sa.Column("figures", sa.JSON(), nullable=False),
        sa.ForeignKeyConstraint(
            ["baseline_id"],
            ["result.id"],
        ),
        sa.ForeignKeyConstraint(
            ["result_id"],
            ["result.id"],
        ),
        sa.PrimaryKeyConstraint("baseline_id", "result_id", "asked"),
    )


def downgrade() -> None:
    op.drop_table("movement")
    with op.batch_alter_table("extraction") as table:
        table.drop_column("worker")
