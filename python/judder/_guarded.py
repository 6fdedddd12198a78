"""Stores whose arrays are those of one run: what another run has replaced is an error when it is read, never its values."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from zarr.storage import WrapperStore

from judder import _judder
from judder.errors import StoreError, rewritten

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Self

    from zarr.abc.store import ByteRequest, Store
    from zarr.core.buffer import Buffer, BufferPrototype

    from judder._memory import TemporaryFolder

_METADATA = "zarr.json"


class GuardedStore(WrapperStore["Store"]):
    """The store of a study for the reader of one of its groups.

    Values are fetched when they are used, long after the metadata. So whenever some are fetched, the group must still have the hash of all that
    they depend on; and a part that is not there is no part without values.
    """

    def __init__(
        self,
        store: Store,
        folder: str,
        name: str,
        expected: str | None,
        owner: TemporaryFolder | None,
        files: Mapping[str, tuple[int, str]] | None = None,
    ) -> None:
        super().__init__(store)
        self._folder, self._name, self._expected = folder, name, expected
        # size and hash of what is stored, where a manifest says them
        self._files = files or {}
        # the folder lasts until nobody reads from it any more
        self._owner = owner

    def _with_store(self, store: Store) -> Self:
        return type(self)(store, self._folder, self._name, self._expected, self._owner, self._files)

    async def get(self, key: str, prototype: BufferPrototype, byte_range: ByteRequest | None = None) -> Buffer | None:
        """What the store has under a key.

        Raises:
            RewrittenError: the group is no longer that of the reader.
            StoreError: values are missing, or not those that were written.
        """
        content = await self._store.get(key, prototype, byte_range)
        own = f"{self._name}/{_METADATA}"
        if key == own and content is not None:
            self._check(content)
        elif not key.endswith(_METADATA):
            # looked at after the values: what is replaced in between is found out
            self._check(await self._store.get(own, prototype))
            if content is None:
                message = f"{self._folder}/results.zarr/{key}: this part of `{self._name}` is not there; `judder run` computes it again"
                raise StoreError(message, "MissingChunk", {"path": f"{self._folder}/results.zarr/{key}"})
        if content is not None and byte_range is None:
            self._compare(f"results.zarr/{key}", content)
        return content

    def _compare(self, path: str, content: Buffer) -> None:
        """Refuses a file that is not as it was written."""
        if path in self._files:
            size, expected = self._files[path]
            _judder.vouch_for_content(f"{self._folder}/{path}", size, expected, content.to_bytes())

    def _check(self, metadata: Buffer | None) -> None:
        """Refuses the metadata of another group than the reader's."""
        found = None if metadata is None else json.loads(metadata.to_bytes()).get("attributes", {}).get("judder_hash")
        if self._expected is not None and found != self._expected:
            raise rewritten(self._folder, self._name, self._expected, found)
