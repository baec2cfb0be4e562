"""Whether an epoch was scanned or levelled."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("epoch") as table:
        table.add_column(
            sa.Column("kind", sa.Text(), server_default="scan", nullable=False)
        )


def downgrade() -> None:
    with op.batch_alter_table("epoch") as table:
        table.drop_column("kind")
