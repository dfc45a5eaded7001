// The teller's header, precompiled for all sections.
