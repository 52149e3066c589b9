// Nobody includes this.
