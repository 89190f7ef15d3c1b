{loop(1000000)}
{loop(1000000)}
{s = s // 'xxxxxxxxxxxxxxxx'}
{endloop}
{endloop}
