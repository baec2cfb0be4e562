"""Runs the migrations on the connection that history.py gives."""

from __future__ import annotations

from alembic import context

from tank_datum.farm.models import Base

connection = context.config.attributes["connection"]
context.configure(
    connection=connection,
    target_metadata=Base.metadata,
    render_as_batch=connection.dialect.name == "sqlite",
    transactional_ddl=False,  # the transaction is history.py's
)
with context.begin_transaction():
    context.run_migrations()
