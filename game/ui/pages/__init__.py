"""The pages that lie over the table until they are closed."""
